#include "tests/bench/every_panel.h"

#include "app/ui/plots/plots_panel.h"

#include <QApplication>
#include <QDockWidget>

using namespace app;

namespace {

QDockWidget *dock(const MainWindow &window, const char *name)
{
    return window.findChild<QDockWidget *>(name);
}

void addPlots(MainWindow &window)
{
    while (window.plots().cards().size() < 3)
        window.plots().add(
            {{window.plots().cards().size() == 1 ? QuantityKind::speed : QuantityKind::energy}});
}

}

void openStep(Session &session, const QString &what)
{
    const QStringList parts = what.split(',');
    session.openStep(parts.front().section('/', 0, 0), parts.front().section('/', 1));
    session.editor().startAfresh();
    for (const QString &part : parts.mid(1))
        session.editor().setParameter(part.section('=', 0, 0), part.section('=', 1).toDouble());
}

void openEveryPanel(MainWindow &window)
{
    addPlots(window);
    window.setMode(MainWindow::Mode::measure); // starts the accuracy measurement
    if (dock(window, "lessons")->isHidden() || dock(window, "code")->isHidden()) {
        window.setMode(MainWindow::Mode::learn);
        window.docks().show(Panel::energy, true);
        window.tabifyDockWidget(dock(window, "code"), dock(window, "accuracy"));
        dock(window, "accuracy")->show();
    }
    window.docks().show(Panel::plots, true);
    window.docks().show(Panel::effects, true);
    QApplication::processEvents();
}

void showEveryPanel(MainWindow &window)
{
    addPlots(window);
    window.setMode(MainWindow::Mode::learn);
    window.docks().show(Panel::plots, true);
    window.docks().show(Panel::energy, true);
    window.docks().show(Panel::effects, true);
    for (const char *name : {"branches", "effects", "energy"}) // the only way to remove a dock from its tabs
        window.removeDockWidget(dock(window, name));
    for (const char *name : {"energy", "effects"}) {
        window.addDockWidget(Qt::BottomDockWidgetArea, dock(window, name));
        dock(window, name)->show();
    }
    QApplication::processEvents();
}
