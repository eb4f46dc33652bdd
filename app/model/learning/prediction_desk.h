#pragma once

#include "app/model/jobs/background_job.h"
#include "app/model/learning/prediction_truth.h"
#include "app/model/session/session.h"

#include <QHash>
#include <QObject>

#include <optional>

namespace app {

/// The predictions of the open step: what the learner says, the run that she then sees, and what came out. The truth is
/// computed in the background, from a separate run. Answers are stored in the learner's notes.
class PredictionDesk : public QObject
{
    Q_OBJECT

public:
    enum class Stage {
        open,    ///< the learner has not committed to an answer
        playing, ///< the run plays
        shown,   ///< answer and truth are shown
    };
    /// A prediction and how far the learner is with it.
    struct Sheet
    {
        Stage stage = Stage::open;
        std::optional<PredictedAnswer> said = {};
        std::optional<PredictedAnswer> found = {}; ///< once it is shown
        bool wasInterrupted = false;               ///< whether the run was changed while it played
        QString mistake = {};                      ///< why there is no such run; empty: there is one
    };
    /// A place that the learner has predicted, while the scene shows the run of the prediction.
    struct PlaceMark
    {
        sim::Vec2 said;                      ///< px
        std::optional<sim::Vec2> found = {}; ///< once it is shown
        friend bool operator==(const PlaceMark &, const PlaceMark &) = default;
    };

    /// `session` must outlive this object.
    explicit PredictionDesk(Session &session, QObject *parent = nullptr);

    /// Returns the sheet of a prediction of the open step. An unknown id has an empty one.
    Sheet sheet(const QString &id) const;
    /// Returns the truth of a prediction of the open step; null while it is not known.
    const PredictionTruth *truth(const QString &id) const;

    /// Takes down an answer, or none. Ignored once the learner has committed to one.
    void say(const QString &id, const std::optional<PredictedAnswer> &answer);
    /// Commits to the answer: sets the run up, which can be undone, plays it from frame 0, and pauses at its end.
    /// Without an answer, nothing happens.
    void commit(const QString &id);
    /// Forgets the answer, so that the learner can predict again. The note stays until she commits.
    void startAgain(const QString &id);

    /// Sets the run up, paused at frame 0, and lets the learner choose the place in the scene.
    void pick(const QString &id);
    void stopPicking();
    /// Returns the prediction whose place is being chosen; null if there is none.
    const lessons::Prediction *picking() const;
    /// Returns where the body that the question is about is now, px.
    sim::Vec2 placeOfBody() const;
    /// Returns what the scene shows; empty if it shows another run, or there is no place.
    std::optional<PlaceMark> mark() const;

signals:
    /// A sheet, a truth or what the scene shows has changed.
    void changed();
    /// The learner is to choose a place: the scene should have the focus.
    void pickingStarted();

private:
    QString keyOf(const QString &id) const;
    const lessons::Prediction *find(const QString &id) const;
    void openStep();
    void computeTruths();
    void receive(const QString &id, std::future<std::optional<PredictionTruth>> truth);
    void follow(const Change &change);
    /// Makes the run of `prediction` the open one. Returns whether there is such a run.
    bool setUp(const lessons::Prediction &prediction);
    void begin();
    void interrupt();
    void finish();

    Session &m_session;
    QString m_step;                           ///< key of the open step
    QHash<QString, Sheet> m_sheets;           ///< by key of the note
    QHash<QString, PredictionTruth> m_truths; ///< by id
    QString m_active;                         ///< id of the prediction that was set up last
    std::optional<sim::Script> m_script;      ///< its run
    bool m_isOnStage = false;                 ///< whether that is the open run
    bool m_isPicking = false;
    bool m_changesRun = false; ///< whether this object changes the run
    BackgroundJob m_job;
};

}
