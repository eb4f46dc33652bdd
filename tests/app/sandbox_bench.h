#pragma once

#include "app/model/workbench.h"
#include "app/ui/effects/effect_list.h"
#include "app/ui/effects/effects_panel.h"
#include "app/ui/panels/number_box.h"
#include "app/ui/sandbox/build_panel.h"
#include "app/ui/sandbox/example_gallery.h"
#include "app/ui/sandbox/property_row.h"
#include "app/ui/sandbox/scene_builder.h"
#include "app/ui/scene/scene_view.h"
#include "app/ui/window/main_window.h"
#include "panels_bench.h"
#include "studies.h"

#include <QAction>
#include <QCheckBox>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <QtTest>

#include <cmath>

namespace sandbox_bench {

using namespace app;

/// The window, and hands that build in it.
struct Bench
{
    explicit Bench(QSize size = {1280, 800}) { show(window, size); }

    Session &session() { return world.session; }
    SceneView &view() const { return *window.findChild<SceneView *>(); }
    Workbench &bench() const { return *window.findChild<Workbench *>(); }
    BuildPanel &panel() const { return *window.findChild<BuildPanel *>(); }
    const sim::Blueprint &plan() const { return bench().plan(); }
    QPoint on(sim::Vec2 place) const { return Camera(view().viewportTransform()).at(place).toPoint(); }

    void build() { window.setMode(MainWindow::Mode::build); }
    void click(sim::Vec2 place, Qt::KeyboardModifiers keys = {})
    {
        QTest::mouseClick(view().viewport(), Qt::LeftButton, keys, on(place));
    }
    void drag(sim::Vec2 from, sim::Vec2 to)
    {
        QTest::mousePress(view().viewport(), Qt::LeftButton, {}, on(from));
        QTest::mouseMove(view().viewport(), on({(from.x + to.x) / 2, (from.y + to.y) / 2}));
        QTest::mouseMove(view().viewport(), on(to));
        QTest::mouseRelease(view().viewport(), Qt::LeftButton, {}, on(to));
    }
    void key(int key, Qt::KeyboardModifiers modifiers = {})
    {
        QTest::keyClick(&view(), Qt::Key(key), modifiers);
    }
    /// Types a number into the field of a property, as after a click on it.
    void type(const QString &id, const QString &number)
    {
        auto *box = row(id)->findChild<NumberBox *>();
        QTest::mouseClick(box, Qt::LeftButton);
        box->selectAll();
        QTest::keyClicks(box, number);
        QTest::keyClick(box, Qt::Key_Return);
    }
    PropertyRow *row(const QString &id) const
    {
        for (PropertyRow *one : panel().rows()) {
            if (one->property().about.id == id)
                return one;
        }
        return nullptr;
    }
    QCheckBox *effect(const QString &text) const
    {
        for (QCheckBox *one : panel().findChildren<QCheckBox *>()) {
            if (one->text() == text)
                return one;
        }
        return nullptr;
    }
    QPushButton *button(const QString &text) const
    {
        for (QPushButton *one : panel().findChildren<QPushButton *>()) {
            if (one->text() == text)
                return one;
        }
        return nullptr;
    }

    World world{LessonLibrary::load({LESSON_DIR})};
    MainWindow window{world.session, world.theme, noStudy, noCost};
};

inline bool isNear(sim::Vec2 a, sim::Vec2 b, double most)
{
    return sim::length(a - b) <= most;
}

}
