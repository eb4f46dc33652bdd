#pragma once

#include "app/model/session/session.h"

#include <QObject>

#include <optional>
#include <vector>

namespace app {

/// The recall questions of the lessons. The desk keeps the answers in the learner's notes, and opens the scene in which a
/// question is answered by doing. It keeps the run that did it, for the learner's notebook.
class RecallDesk : public QObject
{
    Q_OBJECT

public:
    /// `session` must outlive this object.
    explicit RecallDesk(Session &session, QObject *parent = nullptr);

    /// Returns the key of the answer to a question, in the notes and the proofs: "lesson/recall:id".
    static QString keyOf(const QString &lesson, const QString &question);

    /// Returns the order in which the window shows the choices of a question: always the same, but not that of the document,
    /// in which the right one comes first.
    static std::vector<std::size_t> shuffled(const lessons::RecallQuestion &question);

    /// Returns the choice that the learner made last; empty if she made none.
    std::optional<std::size_t> chosen(const LessonEntry &lesson,
                                      const lessons::RecallQuestion &question) const;
    /// Returns whether the question was answered: by any choice, or by doing.
    bool isAnswered(const LessonEntry &lesson, const lessons::RecallQuestion &question) const;
    /// Keeps the choice with this index in the document. The learner can choose again.
    void choose(const LessonEntry &lesson, const lessons::RecallQuestion &question, std::size_t choice);

    /// Opens the scene of a question that is answered by doing, and watches what the learner does there. Opening another
    /// step ends it. If the scene cannot be opened, says why.
    void start(const LessonEntry &lesson, const lessons::RecallQuestion &question);
    /// Sets the scene up again.
    void startAgain();
    void stop();
    /// Returns the question that is answered in the scene now, and its lesson; null if there is none.
    const lessons::RecallQuestion *question() const;
    const LessonEntry *lesson() const;
    /// Returns whether the learner has done what question() asks for, since it was started.
    bool isDone() const { return m_isDone; }

signals:
    /// The question in the scene is another one, or it is done.
    void changed();

private:
    bool setUp(const lessons::RecallTask &task);
    void followStep();
    void followRun();
    void keepProof(const QString &key);

    Session &m_session;
    QString m_lesson; ///< ids; empty: nothing is answered in the scene
    QString m_question;
    sim::Script m_begun; ///< the run before the learner does something
    bool m_isDone = false;
    bool m_isStarting = false;
};

/// Returns whether a run of the step of `task` fulfils its condition at the cursor, with the method that `task` names.
bool isTaskDone(const lessons::RecallTask &task, const lessons::Step &step, const sim::Timeline &run);

/// Checks that the scenes of all questions exist, and that their values and conditions fit them.
/// @throws lessons::DocumentError if not
void checkRecall(const lessons::Recall &recall, const LessonLibrary &library);

}
