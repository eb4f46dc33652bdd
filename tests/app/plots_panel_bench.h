#pragma once

#include "app/ui/plots/plot_card.h"
#include "app/ui/plots/plots_panel.h"
#include "app/ui/scene/flat_button.h"
#include "tests/app/panels_bench.h"
#include "tests/app/plots_bench.h"

#include <QMenu>
#include <QSettings>
#include <QtTest>

/// What the suites of the panel of plots share: the panel as a window, and hands for it.
namespace plots_panel_bench {

using namespace app;

struct Bench
{
    explicit Bench(const char *step = "pair", QSize size = {420, 420})
    {
        QSettings().clear();
        panel.emplace(world.session, world.theme);
        session().openStep("plots", step);
        show(*panel, size);
    }
    Session &session() { return world.session; }
    QuantityPlot &plot(std::size_t index = 0) { return panel->cards()[index]->plot(); }
    void goTo(std::int64_t frame)
    {
        session().goTo({frame, 0});
        settle();
    }
    void settle()
    {
        QVERIFY(QTest::qWaitFor([&] { return !session().goingTo() && panel->isSettled(); }));
    }
    std::int64_t frame() { return session().timeline().cursor().frame; }
    void hover(QPoint place, std::size_t index = 0, Qt::MouseButtons buttons = {})
    {
        QMouseEvent move(QEvent::MouseMove, place, plot(index).mapToGlobal(place), Qt::NoButton, buttons, {});
        QApplication::sendEvent(&plot(index), &move);
    }
    /// Opens the menu of a card's name and takes an entry of it, or of a menu in it.
    void choose(const char *entry, const char *inMenu = nullptr, int button = 0)
    {
        QMenu *menu = panel->cards()[0]->findChildren<FlatButton *>()[button]->menu();
        menu->popup({});
        if (inMenu)
            menu = entryOf(*menu, inMenu)->menu();
        entryOf(*menu, entry)->trigger();
        for (QWidget *open = QApplication::activePopupWidget(); open;
             open = QApplication::activePopupWidget())
            open->close();
        settle();
    }
    static QAction *entryOf(const QMenu &menu, const QString &text)
    {
        for (QAction *one : menu.actions()) {
            if (one->text().remove('&').startsWith(text))
                return one;
        }
        qFatal("there is no entry %s", qPrintable(text));
    }
    int pixels(const QColor &color, const QImage &image)
    {
        int count = 0;
        for (int y = 0; y < image.height(); ++y) {
            for (int x = 0; x < image.width(); ++x)
                count += image.pixelColor(x, y) == color ? 1 : 0;
        }
        return count;
    }

    World world{plots_bench::library()};
    std::optional<PlotsPanel> panel;
};

}
