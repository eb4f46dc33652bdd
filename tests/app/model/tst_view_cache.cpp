// The view of a scene is made once for a run, however many frames are shown.

#include "tests/app/support/session_fixture.h"
#include "tests/suite.h"

#include <QtTest>

using namespace app;

namespace {

class ViewCacheTest : public QObject
{
    Q_OBJECT

private slots:
    void aViewIsMadeOnce();
};

void ViewCacheTest::aViewIsMadeOnce()
{
    int made = 0;
    LessonLibrary library = tests::twoLessons();
    lessons::Step &step = library.lessons.front().steps.front();
    step.view = [&made, view = step.view](const sim::Scene &scene, const sim::Values &values) {
        ++made;
        return view(scene, values);
    };
    tests::SessionFixture fixture(std::move(library));
    Session &session = fixture.session;
    const auto show = [&session](std::int64_t frame) {
        session.playback().goTo({frame, 0});
        QVERIFY(session.presentation().picture().view != nullptr);
    };
    for (std::int64_t frame = 0; frame <= 20; ++frame)
        show(frame);
    show(3);
    QCOMPARE(made, 1);
    session.editor().setMethod("semi_implicit_euler"); // another run
    show(20);
    show(4);
    QCOMPARE(made, 2);
}

}

SUITE(tst_view_cache, ViewCacheTest)
#include "tst_view_cache.moc"
