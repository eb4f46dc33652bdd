#include "app/ui/dock/live_panel.h"

#include "app/ui/dock/panel_parts.h"

namespace app {

namespace {

constexpr int refreshMilliseconds = 100;

}

LivePanel::LivePanel(QWidget *parent) : QWidget(parent)
{
    styleAsPanel(*this);
    m_refreshTimer.setSingleShot(true);
    connect(&m_refreshTimer, &QTimer::timeout, this, &LivePanel::refreshNow);
}

void LivePanel::refresh()
{
    if (!isSeen())
        return;
    if (!isChanging() || !m_sinceRefresh.isValid() || m_sinceRefresh.hasExpired(refreshMilliseconds))
        refreshNow();
    else if (!m_refreshTimer.isActive())
        m_refreshTimer.start(refreshMilliseconds - static_cast<int>(m_sinceRefresh.elapsed()));
}

void LivePanel::refreshNow()
{
    if (!isSeen())
        return;
    m_refreshTimer.stop();
    m_sinceRefresh.start();
    showContents();
}

void LivePanel::setCovered(bool covered)
{
    m_isCovered = covered;
    updateActive();
}

void LivePanel::updateActive()
{
    setActive(isSeen());
    if (isSeen())
        refreshNow();
    else
        m_refreshTimer.stop();
}

void LivePanel::showEvent(QShowEvent *event)
{
    QWidget::showEvent(event);
    updateActive();
}

void LivePanel::hideEvent(QHideEvent *event)
{
    QWidget::hideEvent(event);
    updateActive();
}

}
