#pragma once

#include "app/model/jobs/background_job.h"
#include "app/model/session/open_run.h"
#include "app/model/session/run_editor.h"
#include "sim/analysis/accuracy/study.h"

#include <QObject>
#include <QTimer>

namespace app {

/// The function that runs a study: sim::studyAccuracy, or a replacement in a test.
using StudyFunction =
    std::function<sim::Accuracy(const sim::Script &, const sim::StudyPlan &, const sim::StudyProgress &)>;

/// A study of the cost of accuracy for the session's scene. It runs on another thread while a view shows it. Once
/// started, it measures again whenever the scene changes. Results of another scene are dropped at once.
class AccuracyStudy : public QObject
{
    Q_OBJECT

public:
    enum class Stage {
        none,      ///< no measurements yet
        measuring, ///< measurements are arriving
        done,
        cancelled, ///< cancelled by the learner; the measurements so far are kept
        refused,   ///< the scene cannot be computed: see error()
    };

    /// Measures on `thread`. Measurements that could disturb each other share a thread.
    AccuracyStudy(const OpenRun &run, RunEditor &editor, StudyFunction function,
                  std::shared_ptr<QThreadPool> thread = makeJobThread(), QObject *parent = nullptr);

    /// Sets whether any view shows the study. It runs only while one does.
    void setActive(bool isActive);
    bool isActive() const { return m_isActive; }
    void start();
    void cancel();

    Stage stage() const { return m_stage; }
    /// Returns the progress, from 0 to 1.
    double done() const { return m_done; }
    /// Returns whether a study starts as soon as the scene stops changing.
    bool isDue() const { return m_settleTimer.isActive(); }
    /// Returns the measurements of the present scene; null if there are none.
    const sim::Accuracy *accuracy() const { return m_accuracy.get(); }
    /// Returns the row of the session's method and step; null if it was not measured.
    const sim::AccuracyRow *inUse() const;
    QString error() const { return m_error; }
    /// Returns why the session's method is not measured: it is the learner's code. Otherwise empty.
    QString leftOut() const;
    /// Sets the session's method and step to those of `setup`.
    void adopt(const sim::MethodSetup &setup);

    const OpenRun &run() const { return m_run; }

    static constexpr int settleMilliseconds = 400; ///< a scene that changes is not measured before
    static constexpr int reportMilliseconds = 100; ///< between two progress reports of a study

signals:
    void changed();

private:
    /// The subject of a study: a run without its method and step.
    struct Subject
    {
        QString lesson;
        QString step;
        sim::Script script;
    };

    void receive(std::shared_ptr<const sim::Accuracy> soFar, double done);
    void finish(std::future<std::shared_ptr<const sim::Accuracy>> result);
    void followRun();
    bool isAbout(const Subject &subject) const;

    const OpenRun &m_run;
    RunEditor &m_editor;
    StudyFunction m_function;
    QTimer m_settleTimer;
    std::optional<Subject> m_subject;
    std::shared_ptr<const sim::Accuracy> m_accuracy;
    Stage m_stage = Stage::none;
    double m_done = 0.0;
    QString m_error;
    bool m_isActive = false;
    BackgroundJob m_job;
};

/// Returns whether two method setups are the same.
bool sameSetup(const sim::MethodSetup &a, const sim::MethodSetup &b);

}
