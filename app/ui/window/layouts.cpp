// Where the panels stand: each preset has an arrangement of its own, which is remembered.

#include "app/ui/panels/dock_title.h"
#include "app/ui/window/main_window.h"

#include <QAction>
#include <QDockWidget>
#include <QMenu>
#include <QPainter>
#include <QSettings>

namespace app {

namespace {

constexpr int wide = 1600; ///< px, from here on measuring has another arrangement

/// What a panel is dragged by that has its title inside: a row of dots.
class Grip : public QWidget
{
public:
    Grip(const Theme &theme, QWidget *parent) : QWidget(parent), m_theme(theme)
    {
        setObjectName("grip");
        setCursor(Qt::SizeAllCursor);
        setToolTip(MainWindow::tr("Drag this panel to where it is to stand"));
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

QString MainWindow::layoutKey(Mode mode) const
{
    switch (mode) {
    case Mode::measure:
        return width() >= wide ? QStringLiteral("window/docksMeasureWide")
                               : QStringLiteral("window/docksMeasure");
    case Mode::build:
        return QStringLiteral("window/docksBuild");
    case Mode::learn:
        break;
    }
    return QStringLiteral("window/docks");
}

void MainWindow::keepLayout()
{
    if (m_layoutKey.isEmpty())
        return; // the window is not arranged yet
    bringAllBack();
    m_layouts[m_layoutKey] = m_focusAction->isChecked() ? m_docksBeforeFocus : saveState();
}

void MainWindow::saveLayouts()
{
    keepLayout();
    QSettings settings;
    for (const auto &[key, state] : m_layouts)
        settings.setValue(key, state);
}

void MainWindow::useLayout(Mode before)
{
    const auto kept = [this](const QString &key) {
        const auto found = m_layouts.find(key);
        return found != m_layouts.end() ? found->second : QSettings().value(key).toByteArray();
    };
    m_layoutKey = layoutKey(m_mode);
    useKeptForm();
    if (restoreState(kept(m_layoutKey)))
        return;
    if (m_mode == Mode::measure) {
        removeDockWidget(m_plotsDock); // arrangePlots() finds its place among those that stay
        arrangeForMeasuring();
    } else if (before == Mode::measure) {
        restoreState(kept(layoutKey(Mode::learn)));
    }
}

void MainWindow::resetLayout()
{
    m_focusAction->setChecked(false);
    showStability(false);
    m_layouts.erase(m_layoutKey);
    QSettings().remove(m_layoutKey);
    QSettings().remove(m_layoutKey + "Rail");
    m_layoutKey = layoutKey(m_mode);
    useKeptForm();
    restoreState(m_firstDocks);
    placeSides();
    if (m_mode == Mode::measure) {
        removeDockWidget(m_plotsDock);
        arrangeForMeasuring();
    }
    arrangePlots();
    fitParameters();
    emit m_session.said(tr("The panels stand as they did at first."));
}

void MainWindow::movePanel(QDockWidget &panel, Qt::DockWidgetArea area)
{
    QDockWidget *beside = nullptr;
    for (QDockWidget *one : findChildren<QDockWidget *>()) {
        if (one != &panel && !one->isHidden() && dockWidgetArea(one) == area)
            beside = one;
    }
    addDockWidget(area, &panel);
    if (beside && area == Qt::BottomDockWidgetArea)
        tabifyDockWidget(beside, &panel); // beside each other they would not fit below the picture
    panel.show();
    panel.raise();
    fitParameters();
}

void MainWindow::setPanelsMovable(bool movable)
{
    for (QDockWidget *panel : findChildren<QDockWidget *>()) {
        panel->setFeatures(movable ? QDockWidget::DockWidgetClosable | QDockWidget::DockWidgetMovable
                                   : QDockWidget::DockWidgetClosable);
        QWidget *title = panel->titleBarWidget();
        const bool isGrip = title->objectName() == QLatin1String("grip");
        if (qobject_cast<DockTitle *>(title) || isGrip == movable)
            continue;
        panel->setTitleBarWidget(movable ? new Grip(m_theme, this) : new QWidget(this));
        title->deleteLater();
    }
}

void MainWindow::makeLayoutMenu()
{
    QMenu *menu = m_view->addMenu(tr("A&rrange panels"));
    menu->setObjectName("arrange");
    menu->setToolTipsVisible(true);
    QAction *movable = action(tr("&Unlock: panels can be moved"), {}, tr("Window"));
    movable->setObjectName("movable");
    movable->setToolTip(tr("Drag a panel by its title to where it is to stand"));
    movable->setCheckable(true);
    connect(movable, &QAction::toggled, this, &MainWindow::setPanelsMovable);
    QAction *reset = action(tr("As &at first"), {}, tr("Window"));
    reset->setObjectName("resetLayout");
    reset->setToolTip(tr("Puts the panels back to where they stood at first, in this preset alone"));
    connect(reset, &QAction::triggered, this, &MainWindow::resetLayout);
    menu->addActions({movable, reset});
    menu->addSeparator();
    for (QDockWidget *panel : findChildren<QDockWidget *>()) {
        QMenu *places = menu->addMenu(panel->windowTitle());
        connect(menu, &QMenu::aboutToShow, places, [places, panel] {
            places->menuAction()->setVisible(!panel->isHidden()); // what is not shown stands nowhere
        });
        const auto add = [&](const QString &text, Qt::DockWidgetArea area) {
            QAction *made = places->addAction(text);
            connect(made, &QAction::triggered, this, [this, panel, area] { movePanel(*panel, area); });
        };
        add(tr("to the &left"), Qt::LeftDockWidgetArea);
        add(tr("to the &right"), Qt::RightDockWidgetArea);
        add(tr("&below the picture"), Qt::BottomDockWidgetArea);
    }
}

}
