#pragma once

#include "sim/forward.h"

#include <QObject>
#include <QThreadPool>

#include <future>
#include <stop_token>
#include <type_traits>

namespace app {

/// Creates a thread for jobs. Jobs that share one never run at the same time. While idle it sleeps, and soon ends.
std::shared_ptr<QThreadPool> makeJobThread();

/// A job that runs work on another thread and delivers its results in the owner's thread, through the event loop.
///
/// Work runs in the order in which it was added, one piece at a time. Its reports arrive in order, then its result.
/// Nothing arrives from work that was cancelled, even if it had finished before. All methods belong to the thread that
/// created the job.
class BackgroundJob
{
    struct Queue;

public:
    /// A handle with which running work checks for cancellation and reports partial results.
    class Context
    {
    public:
        bool isCancelled() const { return m_cancellation.stop_requested(); }
        /// Returns the opposite of isCancelled() as the callback that computations of sim take.
        sim::ShouldContinue shouldContinue() const;
        /// Calls `receive` in the owner's thread, unless the work is cancelled before.
        void report(std::function<void()> receive) const;

    private:
        friend class BackgroundJob;
        Context(std::shared_ptr<Queue> queue, std::stop_token cancellation);

        std::shared_ptr<Queue> m_queue;
        std::stop_token m_cancellation;
    };

    /// Creates a job with its own thread.
    BackgroundJob();
    explicit BackgroundJob(std::shared_ptr<QThreadPool> thread);
    BackgroundJob(const BackgroundJob &) = delete;
    BackgroundJob &operator=(const BackgroundJob &) = delete;
    /// Cancels all work, and waits for the piece that is running.
    ~BackgroundJob();

    /// Cancels all work, and adds `work` in its place.
    template <class Work, class Receive>
    void start(Work work, Receive receive)
    {
        cancel();
        add(std::move(work), std::move(receive));
    }

    /// Adds `work`, to run after all work that was added before. `work(const Context &)` runs on the job's thread.
    /// `receive(std::future<Result>)` is then called in the owner's thread. The future is ready: its get()
    /// returns the result of `work`, or throws its exception.
    template <class Work, class Receive>
    void add(Work work, Receive receive)
    {
        using Result = std::invoke_result_t<Work &, const Context &>;
        const auto task = std::make_shared<std::packaged_task<Result(const Context &)>>(std::move(work));
        enqueue([task](const Context &context) { (*task)(context); },
                [task, receive = std::move(receive)] { receive(task->get_future()); });
    }

    /// Cancels all work and returns at once. Running work ends when it next checks its context.
    void cancel();
    /// Returns whether a result is still to arrive.
    bool isRunning() const { return m_unfinished > 0; }
    /// Waits until all work has run. The results arrive later, through the event loop.
    void wait();

private:
    void enqueue(std::function<void(const Context &)> run, std::function<void()> finish);
    static void runNext(const std::shared_ptr<Queue> &queue);
    static void receiveNext(Queue &queue);

    QObject m_receiver; ///< lives in the owner's thread
    std::shared_ptr<QThreadPool> m_thread;
    std::shared_ptr<Queue> m_queue;
    int m_unfinished = 0; ///< pieces of work whose results have not arrived
};

}
