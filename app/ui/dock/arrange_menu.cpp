#include "app/ui/dock/arrange_menu.h"

#include "app/ui/actions/command.h"
#include "app/ui/dock/panel_title.h"
#include "app/ui/theme/theme.h"

#include <QDockWidget>
#include <QMainWindow>
#include <QPainter>

namespace app {

namespace {

/// A row of dots by which a panel with its title inside is dragged.
class Grip : public QWidget
{
public:
    Grip(const Theme &theme, QWidget *parent) : QWidget(parent), m_theme(theme)
    {
        setObjectName("grip");
        setCursor(Qt::SizeAllCursor);
        setToolTip(ArrangeMenu::tr("Drag this panel to its new place"));
    }
    QSize sizeHint() const override { return {60, height_}; }
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent *) override
    {
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.fillRect(rect(), m_theme.tokens().panel);
        painter.setPen(Qt::NoPen);
        painter.setBrush(m_theme.tokens().ink3);
        const QPointF middle = QRectF(rect()).center();
        for (int i = -2; i <= 2; ++i)
            painter.drawEllipse(middle + QPointF(8.0 * i, 0.0), 1.6, 1.6);
    }

private:
    static constexpr int height_ = 16; ///< px
    const Theme &m_theme;
};

}

ArrangeMenu::ArrangeMenu(QMainWindow &window, Command &unlock, Command &reset, const Theme &theme)
    : QMenu(tr("A&rrange panels"), &window), m_window(window), m_theme(theme)
{
    setObjectName("arrange");
    setToolTipsVisible(true);
    connect(&unlock, &QAction::toggled, this, &ArrangeMenu::setMovable);
    addActions({&unlock, &reset});
    addSeparator();
    for (QDockWidget *panel : m_window.findChildren<QDockWidget *>())
        addPlaces(*panel);
}

void ArrangeMenu::addPlaces(QDockWidget &panel)
{
    QMenu *places = addMenu(panel.windowTitle());
    connect(this, &QMenu::aboutToShow, places, [places, &panel] {
        places->menuAction()->setVisible(!panel.isHidden()); // a hidden panel has no place
    });
    const auto add = [&](const QString &text, Qt::DockWidgetArea area) {
        QAction *made = places->addAction(text);
        connect(made, &QAction::triggered, this, [this, &panel, area] { move(panel, area); });
    };
    add(tr("to the &left"), Qt::LeftDockWidgetArea);
    add(tr("to the &right"), Qt::RightDockWidgetArea);
    add(tr("&below the picture"), Qt::BottomDockWidgetArea);
}

void ArrangeMenu::move(QDockWidget &panel, Qt::DockWidgetArea area)
{
    QDockWidget *beside = nullptr;
    for (QDockWidget *one : m_window.findChildren<QDockWidget *>()) {
        if (one != &panel && !one->isHidden() && m_window.dockWidgetArea(one) == area)
            beside = one;
    }
    m_window.addDockWidget(area, &panel);
    if (beside && area == Qt::BottomDockWidgetArea)
        m_window.tabifyDockWidget(beside, &panel); // side by side they would not fit below the scene
    panel.show();
    panel.raise();
    emit moved();
}

void ArrangeMenu::setMovable(bool movable)
{
    for (QDockWidget *panel : m_window.findChildren<QDockWidget *>()) {
        panel->setFeatures(movable ? QDockWidget::DockWidgetClosable | QDockWidget::DockWidgetMovable
                                   : QDockWidget::DockWidgetClosable);
        QWidget *title = panel->titleBarWidget();
        const bool isGrip = title->objectName() == QLatin1String("grip");
        if (qobject_cast<PanelTitle *>(title) || isGrip == movable)
            continue;
        panel->setTitleBarWidget(movable ? new Grip(m_theme, &m_window) : new QWidget(&m_window));
        title->deleteLater();
    }
}

}
