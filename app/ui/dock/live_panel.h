#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>

namespace app {

/// A panel that follows the run, but only while it is visible. While its contents change all the time it refreshes ten
/// times a second, because numbers that change faster cannot be read.
class LivePanel : public QWidget
{
    Q_OBJECT

public:
    explicit LivePanel(QWidget *parent);

    /// Sets whether another tab covers the panel. It reads and draws nothing then.
    void setCovered(bool covered);
    bool isCovered() const { return isVisible() && m_isCovered; }

protected:
    bool isSeen() const { return isVisible() && !m_isCovered; }
    /// Starts or stops reading the run.
    virtual void setActive(bool isActive) = 0;
    /// Returns whether the contents change all the time.
    virtual bool isChanging() const = 0;
    virtual void showContents() = 0;

    /// Refreshes now, or soon if the panel has just been refreshed.
    void refresh();
    void refreshNow();
    bool isRefreshDue() const { return m_refreshTimer.isActive(); }

    void showEvent(QShowEvent *event) override;
    void hideEvent(QHideEvent *event) override;

private:
    void updateActive();

    QElapsedTimer m_sinceRefresh;
    QTimer m_refreshTimer;
    bool m_isCovered = false;
};

}
