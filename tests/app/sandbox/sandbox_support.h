#pragma once

#include "app/model/sandbox/sandbox_editor.h"
#include "app/ui/effects/effect_list.h"
#include "app/ui/effects/effects_panel.h"
#include "app/ui/parameters/number_box.h"
#include "app/ui/sandbox/build_panel.h"
#include "app/ui/sandbox/example_gallery.h"
#include "app/ui/sandbox/property_row.h"
#include "app/ui/sandbox/scene_builder.h"
#include "tests/app/support/panel_fixture.h"
#include "tests/app/support/window_fixture.h"

#include <QAction>
#include <QCheckBox>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <QtTest>

#include <cmath>

namespace sandbox_support {

using namespace app;

/// The window, and the user input that builds a scene in it.
struct SandboxFixture : tests::WindowFixture
{
    explicit SandboxFixture(QSize size = {1280, 800}) : WindowFixture({.lesson = {}, .size = size}) {}

    SandboxEditor &editor() const { return part<SandboxEditor>(); }
    BuildPanel &panel() const { return part<BuildPanel>(); }
    const sim::Blueprint &plan() const { return editor().plan(); }
    QPoint on(sim::Vec2 place) const { return Camera(view.viewportTransform()).at(place).toPoint(); }

    void build() { window.setMode(MainWindow::Mode::build); }
    void click(sim::Vec2 place, Qt::KeyboardModifiers keys = {})
    {
        QTest::mouseClick(view.viewport(), Qt::LeftButton, keys, on(place));
    }
    void drag(sim::Vec2 from, sim::Vec2 to)
    {
        QTest::mousePress(view.viewport(), Qt::LeftButton, {}, on(from));
        QTest::mouseMove(view.viewport(), on({(from.x + to.x) / 2, (from.y + to.y) / 2}));
        QTest::mouseMove(view.viewport(), on(to));
        QTest::mouseRelease(view.viewport(), Qt::LeftButton, {}, on(to));
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
};

inline bool isNear(sim::Vec2 a, sim::Vec2 b, double most)
{
    return sim::length(a - b) <= most;
}

}
