// The gallery of presets.

#include "tests/app/support/panel_fixture.h"

#include "app/ui/parameters/preset_gallery.h"
#include "tests/suite.h"

#include <QApplication>
#include <QTest>
#include <QToolButton>

#include <memory>

using namespace app;
using namespace tests;

namespace {

LessonLibrary withPresets()
{
    LessonLibrary library = twoLessons();
    library.lessons[0].steps[0].presets = {
        {"Soft", "A spring that hardly pulls.", {{"k", 0.05}}},
        {"Stiff", "A spring that pulls hard.", {{"k", 0.9}, {"damp", 0.5}}},
        {"Lazy", "All keeps its speed.", {{"damp", 1.0}}},
        {"Fourth", "In the second row.", {{"k", 0.3}}},
    };
    return library;
}

struct GalleryFixture : PanelFixture<ParameterPanel>
{
    GalleryFixture() : PanelFixture(withPresets(), {400, 400})
    {
        panel.setPresetPainter([this](const lessons::Step &, const lessons::Preset &preset, QSize size) {
            painted << preset.title;
            QPixmap picture(size);
            picture.fill(Qt::black);
            return picture;
        });
    }

    QToolButton *button() const { return panel.findChild<QToolButton *>("presets"); }
    QList<QToolButton *> cards() const { return panel.findChildren<QToolButton *>("card"); }
    void open()
    {
        QTest::mouseClick(button(), Qt::LeftButton);
        QVERIFY(QApplication::activePopupWidget());
    }
    double value(const char *id) const { return session.editor().parameter(id); }

    QStringList painted;
};

}

class TestGallery : public QObject
{
    Q_OBJECT

private slots:
    void returnTakesACard()
    {
        GalleryFixture fixture;
        fixture.open();
        QTest::keyClick(fixture.cards()[0], Qt::Key_Right);
        QTest::keyClick(fixture.cards()[1], Qt::Key_Return);
        QCOMPARE(fixture.value("k"), 0.9);
        QVERIFY(!QApplication::activePopupWidget());
        QCOMPARE(fixture.session.editor().undoStack().undoText(), QString("Choose “Stiff”"));
    }

    void onlyStepsWithPresetsHaveOne()
    {
        GalleryFixture fixture;
        QVERIFY(fixture.button()->isVisible());
        fixture.session.openStep("one", "second");
        QVERIFY(!fixture.button()->isVisible());
    }

    void nothingIsPaintedBeforeItIsAskedFor()
    {
        GalleryFixture fixture;
        QVERIFY(fixture.painted.isEmpty());
        fixture.open();
        const QStringList all{"Soft", "Stiff", "Lazy", "Fourth"};
        QTRY_COMPARE(fixture.painted, all);
        QCOMPARE(fixture.cards().size(), 4);
        QCOMPARE(fixture.cards()[1]->accessibleDescription(), QString("A spring that pulls hard."));
        QTest::keyClick(fixture.cards()[0], Qt::Key_Escape);
        fixture.open();
        settle();
        QCOMPARE(fixture.painted, all); // and not again
    }

    void aClickRestartsTheStepWithThoseValues()
    {
        GalleryFixture fixture;
        fixture.session.editor().setParameter("damp", 0.7);
        fixture.goTo(20);
        fixture.open();
        QTest::mouseClick(fixture.cards()[0], Qt::LeftButton);
        QVERIFY(!QApplication::activePopupWidget());
        QCOMPARE(fixture.session.timeline().cursor().frame, std::int64_t(0));
        QCOMPARE(fixture.value("k"), 0.05);
        QCOMPARE(fixture.value("damp"), 0.9); // the step's own: the preset does not name it
    }

    void aRunThatPlayedGoesOnPlaying()
    {
        GalleryFixture fixture;
        fixture.session.playback().play();
        fixture.open();
        QTest::mouseClick(fixture.cards()[2], Qt::LeftButton);
        QVERIFY(fixture.session.playback().isPlaying());
        fixture.session.playback().pause();
        QCOMPARE(fixture.value("damp"), 1.0);
    }

    void theKeyboardGoesThroughTheCards()
    {
        GalleryFixture fixture;
        fixture.open();
        QVERIFY(fixture.cards()[0]->hasFocus());
        QTest::keyClick(fixture.cards()[0], Qt::Key_Right);
        QVERIFY(fixture.cards()[1]->hasFocus());
        QTest::keyClick(fixture.cards()[1], Qt::Key_Left);
        QTest::keyClick(fixture.cards()[0], Qt::Key_Down);
        QVERIFY(fixture.cards()[3]->hasFocus());
        QTest::keyClick(fixture.cards()[3], Qt::Key_Right);
        QVERIFY(fixture.cards()[3]->hasFocus());
        QTest::keyClick(fixture.cards()[3], Qt::Key_Space);
        QCOMPARE(fixture.value("k"), 0.3);
    }

    void deletedPanelClosesItsOpenGallery()
    {
        for (const int focused : {0, 3}) {
            auto fixture = std::make_unique<GalleryFixture>();
            fixture->open();
            fixture->cards()[focused]->setFocus();
            fixture.reset();
            QVERIFY(!QApplication::activePopupWidget());
            QCoreApplication::processEvents();
        }
    }

    void escapeClosesItAndChangesNothing()
    {
        GalleryFixture fixture;
        fixture.open();
        QTest::keyClick(fixture.cards()[0], Qt::Key_Escape);
        QVERIFY(!QApplication::activePopupWidget());
        QCOMPARE(fixture.value("k"), 0.2);
    }
};

SUITE(tst_gallery, TestGallery)
#include "tst_gallery.moc"
