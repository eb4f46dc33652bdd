#pragma once

#include "app/model/session/change.h"

#include <QObject>
#include <QStringList>

#include <functional>
#include <utility>

namespace app {

/// Announces the changes of a session. Changes made within one Batch are announced together, when everything is
/// consistent again, so that each widget repaints once.
class ChangeNotifier : public QObject
{
    Q_OBJECT

public:
    /// Collects changes and messages while it exists. Batches can be nested: the outermost one announces.
    class Batch
    {
    public:
        explicit Batch(ChangeNotifier &changes) : m_changes(changes) { ++m_changes.m_depth; }
        ~Batch();
        Batch(const Batch &) = delete;
        Batch &operator=(const Batch &) = delete;

    private:
        ChangeNotifier &m_changes;
    };

    /// Sets the function that brings the session's own parts up to date before changes of these kinds are announced.
    /// Changes that it announces belong to the same change.
    void setPreparation(std::function<void(ChangeKinds)> prepare) { m_prepare = std::move(prepare); }
    void announce(ChangeKinds kinds, std::int64_t firstFrame = Change::noFrame);
    /// Shows `sentence` in the status line, after the changes of the batch.
    void showMessage(const QString &sentence);

signals:
    void changed(const app::Change &change);
    void messageRequested(const QString &sentence);

private:
    void flush();

    std::function<void(ChangeKinds)> m_prepare;
    int m_depth = 0; ///< of nested batches
    Change m_pending;
    QStringList m_sentences;
};

}
