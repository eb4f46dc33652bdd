// Parameters that lessons without C++ declare, dragged in their listing.

#include "tests/app/listing/listing_window.h"

#include "app/model/lesson_folders/lesson_folder.h"
#include "app/model/run/run_program.h"
#include "app/ui/parameters/number_box.h"
#include "app/ui/parameters/parameter_row.h"
#include "sim/methods/methods.h"
#include "tests/app/support/panel_fixture.h"
#include "tests/suite.h"

using namespace app;
using namespace listing_window;

namespace {

LessonLibrary withCaterpillar()
{
    LessonLibrary library = LessonLibrary::load({LESSON_DIR});
    library.yours.push_back(readLesson(QStringLiteral(SOURCE_DIR "/lessons/examples/caterpillar"), library));
    return library;
}

/// The listing of two bodies on a spring, whose stiffness `k` is a parameter of the lesson.
struct SliderFixture : tests::WindowFixture
{
    SliderFixture()
        : WindowFixture(
              {.lesson = "caterpillar", .step = "pair", .library = withCaterpillar(), .codePage = "listing"})
    {
    }

    /// Returns the middle of `k` in the listing's pull.
    QPoint middleOfK() const
    {
        const QStringList lines = editor.text().split('\n');
        for (int i = 0; i < lines.size(); ++i) {
            const auto column = static_cast<int>(lines[i].indexOf("k * (length"));
            if (column >= 0)
                return editor.wordRect({i + 1, column + 1, 1}).center();
        }
        return {};
    }
    double stiffness() const { return session.editor().parameter("k"); }
    /// Returns where the head is after 50 frames, if it starts 50 px too far to the right, by `method`.
    sim::Vec2 headBy(sim::MethodPtr method) const
    {
        sim::Script script = session.timeline().script();
        script.method = std::move(method);
        script.bodies["head"] = {{360.0, 200.0}, {}};
        sim::Track run(std::move(script), 0);
        run.seek({50, 0});
        return run.state().positionOf(run.interval().scene.find("head"));
    }

    ListingEditor &editor = part<CodePages>().listing().editor();
};

}

class LessonSliders : public QObject
{
    Q_OBJECT

private slots:
    void aParameterOfALessonIsDraggedInItsListing()
    {
        SliderFixture shown;
        QCOMPARE(shown.stiffness(), 0.05); // that of the scene
        const sim::Vec2 before = shown.headBy(sim::findMethod("semi_implicit_euler"));
        const QString text = shown.editor.text();
        tests::dragMouse(*shown.editor.viewport(), shown.middleOfK(), {40, 0});
        QCOMPARE(shown.stiffness(), 0.09); // 200 px are the range, which is 0.2
        QCOMPARE(shown.editor.text(), text);
        const auto &row = *tests::rowOf(shown.part<ParameterPanel>(), "k");
        QCOMPARE(row.findChild<NumberBox *>()->text(), QString("0.09"));

        // The spring of the scene and the listing have the new stiffness.
        const sim::Vec2 after = shown.headBy(sim::findMethod("semi_implicit_euler"));
        QVERIFY(std::abs(after.x - before.x) > 1.0);
        shown.session.code().write(text + "\n// the same\n");
        tests::settle();
        QVERIFY(programOf(shown.session.timeline().script().method));
        QVERIFY(isNear(shown.headBy(shown.session.timeline().script().method), after));
        tests::dragMouse(*shown.editor.viewport(), shown.middleOfK(), {-400, 0});
        QCOMPARE(shown.stiffness(), 0.0); // no farther than the slider
        QTest::keyClick(&shown.view, Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(shown.stiffness(), 0.09);
    }
};

SUITE(tst_lesson_sliders, LessonSliders)
#include "tst_lesson_sliders.moc"
