#include "app/model/jobs/background_job.h"

#include <condition_variable>
#include <deque>
#include <mutex>

namespace app {

/// The state that a job shares with its thread.
struct BackgroundJob::Queue
{
    struct Task
    {
        std::function<void(const Context &)> run; ///< throws nothing
        std::function<void()> finish;             ///< for the owner's thread
    };

    std::mutex mutex; ///< guards all members
    std::condition_variable taskEnded;
    QObject *receiver = nullptr; ///< outlives running work
    std::deque<Task> waiting;
    std::deque<std::function<void()>> reports; ///< not yet received
    std::stop_source cancellation;             ///< of all work so far
    bool isRunning = false;
};

std::shared_ptr<QThreadPool> makeJobThread()
{
    auto thread = std::make_shared<QThreadPool>();
    thread->setMaxThreadCount(1);
    return thread;
}

BackgroundJob::Context::Context(std::shared_ptr<Queue> queue, std::stop_token cancellation)
    : m_queue(std::move(queue)), m_cancellation(std::move(cancellation))
{
}

sim::ShouldContinue BackgroundJob::Context::shouldContinue() const
{
    return [cancellation = m_cancellation] { return !cancellation.stop_requested(); };
}

void BackgroundJob::Context::report(std::function<void()> receive) const
{
    const std::lock_guard lock(m_queue->mutex);
    if (isCancelled())
        return;
    m_queue->reports.push_back(std::move(receive));
    QMetaObject::invokeMethod(
        m_queue->receiver, [queue = m_queue] { receiveNext(*queue); }, Qt::QueuedConnection);
}

BackgroundJob::BackgroundJob() : BackgroundJob(makeJobThread()) {}

BackgroundJob::BackgroundJob(std::shared_ptr<QThreadPool> thread)
    : m_thread(std::move(thread)), m_queue(std::make_shared<Queue>())
{
    Q_ASSERT(m_thread->maxThreadCount() == 1);
    m_queue->receiver = &m_receiver;
}

BackgroundJob::~BackgroundJob()
{
    cancel();
    wait();
}

void BackgroundJob::cancel()
{
    // Destroyed after the mutex is released, because work may hold anything.
    std::deque<Queue::Task> waiting;
    std::deque<std::function<void()>> reports;
    const std::lock_guard lock(m_queue->mutex);
    m_queue->cancellation.request_stop();
    m_queue->cancellation = std::stop_source();
    waiting.swap(m_queue->waiting);
    reports.swap(m_queue->reports);
    m_unfinished = 0;
}

void BackgroundJob::wait()
{
    std::unique_lock lock(m_queue->mutex);
    m_queue->taskEnded.wait(lock, [this] { return m_queue->waiting.empty() && !m_queue->isRunning; });
}

void BackgroundJob::enqueue(std::function<void(const Context &)> run, std::function<void()> finish)
{
    ++m_unfinished;
    {
        const std::lock_guard lock(m_queue->mutex);
        m_queue->waiting.push_back({std::move(run), [this, finish = std::move(finish)] {
                                        --m_unfinished;
                                        finish();
                                    }});
    }
    m_thread->start([queue = m_queue] { runNext(queue); });
}

void BackgroundJob::runNext(const std::shared_ptr<Queue> &queue)
{
    std::unique_lock lock(queue->mutex);
    if (queue->waiting.empty())
        return; // the work was cancelled
    {
        const Context context(queue, queue->cancellation.get_token());
        Queue::Task task = std::move(queue->waiting.front());
        queue->waiting.pop_front();
        queue->isRunning = true;
        lock.unlock();
        task.run(context);
        context.report(std::move(task.finish));
    }
    lock.lock();
    queue->isRunning = false;
    queue->taskEnded.notify_all();
}

void BackgroundJob::receiveNext(Queue &queue)
{
    std::function<void()> receive;
    {
        const std::lock_guard lock(queue.mutex);
        if (queue.reports.empty())
            return; // the work was cancelled
        receive = std::move(queue.reports.front());
        queue.reports.pop_front();
    }
    receive();
}

}
