#pragma once

#include "app/model/accuracy_study.h"

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>

class QLabel;

namespace app {

/// The figures at the right of the status bar: how large the scene is, how much work a frame is, and, once accuracy
/// was measured on it, what a frame takes and how far off the method in use is. A figure that nobody has measured
/// is not there.
class StatusFigures : public QWidget
{
    Q_OBJECT

public:
    /// Both must outlive this.
    StatusFigures(const Session &session, const AccuracyStudy &study, QWidget *parent = nullptr);

    /// What is shown, from left to right.
    QStringList figures() const;
    /// Shows those that fit into `width`, px; what was measured comes before what is counted.
    void setRoom(int width);

    static constexpr int refreshMilliseconds = 100; ///< between two changes while the run plays

private:
    enum Figure { points, work, time, error, count };

    void refresh();
    /// As refresh(), but no more often than the eye can read.
    void refreshSoon();
    void put(Figure figure, const QString &text);
    void fit();
    QString workWords() const;

    const Session &m_session;
    const AccuracyStudy &m_study;
    QLabel *m_labels[count];
    int m_room = QWIDGETSIZE_MAX; ///< px
    QTimer m_later;
    QElapsedTimer m_since;
};

}
