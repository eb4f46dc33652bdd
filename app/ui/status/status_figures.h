#pragma once

#include "app/model/analysis/accuracy_study.h"

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>

class QLabel;

namespace app {

/// The numbers at the right of the status bar: the size of the scene and the work per frame. After an
/// accuracy measurement they include the time per frame and the error of the current method. A number that
/// has not been measured is hidden.
class StatusFigures : public QWidget
{
    Q_OBJECT

public:
    /// All of them must outlive this.
    StatusFigures(const OpenRun &run, const Playback &playback, const AccuracyStudy &study,
                  QWidget *parent = nullptr);

    /// Returns the numbers that are shown, from left to right.
    QStringList figures() const;
    /// Sets the largest width that the numbers may take, px; the sentence beside them has the rest. If they
    /// do not all fit, the first ones are hidden.
    void setMost(int px);

    static constexpr int refreshMilliseconds = 100; ///< between two changes while the run plays

private:
    enum Figure { points, work, time, error, count };

    void refresh();
    /// Refreshes like refresh(), but not faster than a person can read.
    void refreshSoon();
    void put(Figure figure, const QString &text);
    void showWhatFits();
    QString workWords() const;

    const OpenRun &m_run;
    const Playback &m_playback;
    const AccuracyStudy &m_study;
    QLabel *m_labels[count];
    int m_most = 0; ///< px
    QTimer m_refreshTimer;
    QElapsedTimer m_since;
};

}
