#pragma once

#include "app/model/session/session.h"

#include <random>

/// Random gestures of a learner that can be undone, at random moments of a short run.
class RandomGestures
{
public:
    /// Runs go as far as `frames`.
    RandomGestures(app::Session &session, unsigned seed, int frames)
        : m_session(session), m_dice(seed), m_frames(frames)
    {
    }

    /// Goes to a random moment and makes a random gesture there.
    void act();
    /// Returns all gestures, for a message.
    QString done() const { return m_done.join(QStringLiteral(", ")); }

private:
    int below(int n) { return static_cast<int>(m_dice() % static_cast<unsigned>(n)); }
    double share() { return below(1001) / 1000.0; }
    void go(std::int64_t frame);
    void parameter();
    void drag();
    void effect();
    void method();
    void preset();
    void outside();
    void branch();

    app::Session &m_session;
    std::mt19937 m_dice;
    int m_frames;
    QStringList m_done;
};

/// Waits until the session is where it was told to go.
void arrive(const app::Session &session);
