#pragma once

#include "app/model/session.h"
#include "sim/analysis/accuracy/study.h"

#include <QObject>
#include <QTimer>

#include <thread>

namespace app {

/// How a study is computed: sim::studyAccuracy, or a test's own.
using StudyFunction =
    std::function<sim::Accuracy(const sim::Script &, const sim::StudyPlan &, const sim::StudyProgress &)>;

/// What accuracy costs on the session's scene, measured on a thread of its own while somebody watches. Once asked
/// for, it measures again when the scene changes; what belongs to another scene is dropped at once.
class AccuracyStudy : public QObject
{
    Q_OBJECT

public:
    enum class Stage {
        none,      ///< nothing was measured yet
        measuring, ///< rows come in
        done,
        cancelled, ///< stopped by the learner; what was measured until then stays
        refused,   ///< the scene cannot be computed: see refusal()
    };

    AccuracyStudy(Session &session, StudyFunction function, QObject *parent = nullptr);
    /// Stops a study and waits for its thread.
    ~AccuracyStudy() override;

    /// Whether anything shows what is measured. Where nothing does, nothing is computed.
    void setWatched(bool watched);
    bool isWatched() const { return m_watched; }
    void start();
    void cancel();

    Stage stage() const { return m_stage; }
    /// From 0 to 1.
    double done() const { return m_done; }
    /// Whether a study will begin by itself as soon as the scene has stopped changing.
    bool isDue() const { return m_later.isActive(); }
    /// What is known about the scene as it is now; null where nothing is.
    const sim::Accuracy *accuracy() const { return m_accuracy.get(); }
    /// The row of the method and step that the session uses; null where it was not measured.
    const sim::AccuracyRow *inUse() const;
    QString refusal() const { return m_refusal; }
    /// Uses the method and step of `way` from now on.
    void adopt(const sim::MethodSetup &setup);

    const Session &session() const { return m_session; }

    static constexpr int settleMilliseconds = 400; ///< a scene that changes is not measured before
    static constexpr int tellMilliseconds = 100;   ///< between two reports of a study

signals:
    void changed();

private:
    /// One study, shared with its thread.
    struct Run;
    /// What a study is about: a run without its method and step.
    struct Subject
    {
        QString lesson;
        QString step;
        sim::Script script;
    };

    void begin();
    void stop();
    void take(const std::shared_ptr<Run> &run, std::shared_ptr<const sim::Accuracy> accuracy, double done);
    void end(const std::shared_ptr<Run> &run);
    void follow();
    bool isAbout(const Subject &subject) const;

    Session &m_session;
    StudyFunction m_function;
    QTimer m_later;
    std::thread m_thread;
    std::shared_ptr<Run> m_run; ///< under way, or on its way out
    std::optional<Subject> m_subject;
    std::shared_ptr<const sim::Accuracy> m_accuracy;
    Stage m_stage = Stage::none;
    double m_done = 0.0;
    QString m_refusal;
    bool m_watched = false;
    bool m_again = false; ///< a new study begins when the old one has stopped
};

/// Whether two ways are the same.
bool sameWay(const sim::MethodSetup &a, const sim::MethodSetup &b);

}
