#pragma once

#include "app/ui/plots/plot_card.h"
#include "app/ui/plots/plots_panel.h"
#include "app/ui/scene/flat_button.h"
#include "tests/app/model/plots_support.h"
#include "tests/app/support/panel_fixture.h"

#include <QMenu>
#include <QSettings>
#include <QtTest>

/// Shared by the suites of the panel of plots.
namespace plots_panel_support {

using namespace app;
using namespace tests;

struct PlotsFixture : PanelFixture<PlotsPanel>
{
    explicit PlotsFixture(const char *step = "pair", QSize size = {420, 420})
        : PanelFixture(lessonsWithoutSettings(), size)
    {
        session.openStep("plots", step);
        settle();
    }
    QuantityPlot &plot(std::size_t index = 0) { return panel.cards()[index]->plot(); }
    /// Goes to a frame and waits until it is plotted.
    void goTo(std::int64_t frame)
    {
        session.playback().goTo({frame, 0});
        settle();
    }
    void settle()
    {
        QVERIFY(QTest::qWaitFor([&] { return !session.playback().goal() && panel.isSettled(); }));
    }
    std::int64_t frame() { return session.timeline().cursor().frame; }
    void hover(QPoint place, std::size_t index = 0, Qt::MouseButtons buttons = {})
    {
        moveMouse(plot(index), place, buttons);
    }
    /// Chooses an entry of the menu of a card's name, or of a menu in it.
    void choose(const char *entry, const char *inMenu = nullptr, int button = 0)
    {
        QMenu *menu = panel.cards()[0]->findChildren<FlatButton *>()[button]->menu();
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

private:
    /// The panel reads the settings when it is made.
    static LessonLibrary lessonsWithoutSettings()
    {
        QSettings().clear();
        return plots_support::library();
    }
};

}
