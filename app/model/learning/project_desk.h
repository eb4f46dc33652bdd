#pragma once

#include "app/model/jobs/background_job.h"
#include "app/model/learning/project_judge.h"
#include "app/model/session/session.h"

#include <QObject>

#include <map>
#include <optional>

namespace app {

/// The projects of the lessons, and the one that the learner works on. The desk opens the place where she works, judges
/// what she has built, and ticks each level that she has passed.
class ProjectDesk : public QObject
{
    Q_OBJECT

public:
    /// `session` must outlive this object.
    explicit ProjectDesk(Session &session, QObject *parent = nullptr);

    /// Returns the project of a lesson; null if it has none.
    const lessons::Project *projectOf(const QString &lesson) const;
    /// Returns the id of the lesson whose project the learner works on; empty if none.
    const QString &current() const { return m_current; }
    /// Returns the lesson and the step where a project is built.
    std::pair<QString, QString> placeOf(const QString &lesson);
    /// Returns whether the open step is the place of this project.
    bool isAtPlace(const QString &lesson);

    /// Returns the rings that the scene shows: those of the current project, at its place.
    std::vector<lessons::ProjectRing> rings();

    /// Opens the place of a project with its start scene, which can be undone there.
    void start(const QString &lesson);
    /// Opens the step of a project, with the scene as the learner left it.
    void goOn(const QString &lesson);
    /// Puts the current project away. What was built stays.
    void putAway();

    /// Judges the present run at the place of a project.
    void judge(const QString &lesson, const QString &level);
    void cancel();
    /// Returns the id of the level that is being judged; empty if none.
    QString judging(const QString &lesson) const
    {
        return lesson == m_judgedLesson ? m_judgedLevel : QString();
    }
    /// Returns the percentage of the judged run that is computed.
    int percent() const { return m_percent; }
    /// Returns the last judgement on a level since the program was started; null if there is none.
    const ProjectVerdict *verdict(const QString &lesson, const QString &level) const;
    bool isPassed(const QString &lesson, const QString &level) const;
    /// Returns the number of levels of a project that are passed.
    int passedLevels(const QString &lesson) const;

signals:
    /// A project, its place or a judgement changed.
    void changed();
    /// The place of a project was opened.
    void opened();

private:
    /// Returns the experiment that the project of a lesson starts with; null if there is none.
    const Experiment *startOf(const QString &lesson);
    void setCurrent(const QString &lesson);
    void receive(std::future<std::optional<ProjectVerdict>> verdict);
    /// Keeps what was judged as the proof of a level.
    void keepProof(const QString &lesson, const QString &level);

    Session &m_session;
    std::map<QString, std::optional<Experiment>> m_starts; ///< by lesson
    QString m_current;
    QString m_judgedLesson;
    QString m_judgedLevel;
    Experiment m_judged; ///< what the learner has built for it
    int m_percent = 0;
    std::map<std::pair<QString, QString>, ProjectVerdict> m_verdicts; ///< by lesson and level
    BackgroundJob m_job;
};

}
