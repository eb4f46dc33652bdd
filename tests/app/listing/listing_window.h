#pragma once

#include "tests/app/support/window_fixture.h"

#include "app/ui/code/breakpoint_list.h"
#include "app/ui/code/code_pages.h"
#include "app/ui/code/engine/code_panel.h"
#include "app/ui/code/listing/listing_editor.h"
#include "app/ui/code/listing/listing_panel.h"
#include "app/ui/time/timeline_strip.h"

#include <QPushButton>
#include <QToolButton>

#include <cmath>

/// Shared by the suites of the listing's panel.
namespace listing_window {

using namespace app;

/// The window with the page of the listing in front.
struct ListingFixture : tests::WindowFixture
{
    explicit ListingFixture(const QString &lesson = "single_spring", const QString &step = "fixed_centre",
                            const QString &page = "listing")
        : WindowFixture({.lesson = lesson, .step = step, .codePage = page})
    {
    }

    /// Returns the number of the first line that has `part`, from 1; 0 if there is none.
    int line(const QString &part) const
    {
        const QStringList lines = editor.text().split('\n');
        for (int i = 0; i < lines.size(); ++i) {
            if (lines[i].contains(part))
                return i + 1;
        }
        return 0;
    }
    /// Returns the range of `word` in the first line that has `part`.
    TextRange range(const QString &part, const QString &word) const
    {
        const int there = line(part);
        const auto column = static_cast<int>(editor.text(there - 1).indexOf(word));
        return {there, column + 1, static_cast<int>(word.size())};
    }
    QPoint middleOf(const QString &part, const QString &word) const
    {
        return editor.wordRect(range(part, word)).center();
    }
    /// Selects `word` in the first line that has `part`, types `by`, and waits until it is compiled.
    void type(const QString &part, const QString &word, const QString &by)
    {
        const TextRange at = range(part, word);
        editor.setFocus();
        editor.setSelection(at.line - 1, at.column - 1, at.line - 1, at.column - 1 + at.length);
        QTest::keyClicks(&editor, by);
        compile();
    }
    void compile()
    {
        QVERIFY(QTest::qWaitFor([this] { return !editor.isPending(); }));
        tests::settle();
    }
    void clickMargin(int atLine)
    {
        QTest::mouseClick(editor.viewport(), Qt::LeftButton, {}, {20, editor.lineRect(atLine).center().y()});
        QCoreApplication::processEvents();
    }
    void point(const QPoint &at)
    {
        tests::moveMouse(*editor.viewport(), at);
        QCoreApplication::processEvents();
    }
    sim::Vec2 position(const char *body) const
    {
        const sim::Scene &scene = session.timeline().track().interval().scene;
        return session.timeline().state().positionOf(scene.find(body));
    }
    int next() const { return editor.marks().next; }

    CodePages &pages = part<CodePages>();
    ListingPanel &panel = pages.listing();
    ListingEditor &editor = panel.editor();
    TimelineStrip &timeline = part<TimelineStrip>("timeline");
};

inline bool isNear(sim::Vec2 a, sim::Vec2 b)
{
    return std::hypot(a.x - b.x, a.y - b.y) < 1e-9;
}

/// The foot of single_spring/fixed_centre after some frames, from the tutorial's three lines.
inline sim::Vec2 footOnSpring(sim::Vec2 foot, sim::Vec2 centre, double k, double damp, int frames)
{
    double vx = 0.0, vy = 0.0;
    for (int i = 0; i < frames; ++i) {
        vx = (vx + k * (centre.x - foot.x)) * damp;
        vy = (vy + k * (centre.y - foot.y)) * damp;
        foot.x += vx;
        foot.y += vy;
    }
    return foot;
}

}
