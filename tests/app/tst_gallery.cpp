// The gallery of presets.

#include "panels_bench.h"

#include "app/ui/panels/preset_gallery.h"

#include <QApplication>
#include <QTest>
#include <QToolButton>

#include <memory>

using namespace app;

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

struct GalleryBench : World
{
    GalleryBench() : World(withPresets())
    {
        panel.setPresetPainter([this](const lessons::Step &, const lessons::Preset &preset, QSize size) {
            painted << preset.title;
            QPixmap picture(size);
            picture.fill(Qt::black);
            return picture;
        });
        show(panel, {400, 400});
    }

    QToolButton *button() const { return panel.findChild<QToolButton *>("presets"); }
    QList<QToolButton *> cards() const { return panel.findChildren<QToolButton *>("card"); }
    void open()
    {
        QTest::mouseClick(button(), Qt::LeftButton);
        QVERIFY(QApplication::activePopupWidget());
    }
    double value(const char *id) const { return session.parameter(id); }

    ParameterPanel panel{session, theme};
    QStringList painted;
};

}

class TestGallery : public QObject
{
    Q_OBJECT

private slots:
    void returnTakesACard()
    {
        GalleryBench bench;
        bench.open();
        QTest::keyClick(bench.cards()[0], Qt::Key_Right);
        QTest::keyClick(bench.cards()[1], Qt::Key_Return);
        QCOMPARE(bench.value("k"), 0.9);
        QVERIFY(!QApplication::activePopupWidget());
        QCOMPARE(bench.session.deeds().undoText(), QString("Choose “Stiff”"));
    }

    void initTestCase() { prepareProgram(); }

    void onlyStepsWithPresetsHaveOne()
    {
        GalleryBench bench;
        QVERIFY(bench.button()->isVisible());
        bench.session.openStep("one", "second");
        QVERIFY(!bench.button()->isVisible());
    }

    void nothingIsPaintedBeforeItIsAskedFor()
    {
        GalleryBench bench;
        QVERIFY(bench.painted.isEmpty());
        bench.open();
        const QStringList all{"Soft", "Stiff", "Lazy", "Fourth"};
        QTRY_COMPARE(bench.painted, all);
        QCOMPARE(bench.cards().size(), 4);
        QCOMPARE(bench.cards()[1]->accessibleDescription(), QString("A spring that pulls hard."));
        QTest::keyClick(bench.cards()[0], Qt::Key_Escape);
        bench.open();
        QTest::qWait(50);
        QCOMPARE(bench.painted, all); // and not again
    }

    void aClickStartsTheStepAnewWithThoseValues()
    {
        GalleryBench bench;
        bench.session.setParameter("damp", 0.7);
        bench.session.goTo({20, 0});
        bench.open();
        QTest::mouseClick(bench.cards()[0], Qt::LeftButton);
        QVERIFY(!QApplication::activePopupWidget());
        QCOMPARE(bench.session.timeline().cursor().frame, std::int64_t(0));
        QCOMPARE(bench.value("k"), 0.05);
        QCOMPARE(bench.value("damp"), 0.9); // the step's own: the preset does not name it
    }

    void aRunThatPlayedGoesOnPlaying()
    {
        GalleryBench bench;
        bench.session.play();
        bench.open();
        QTest::mouseClick(bench.cards()[2], Qt::LeftButton);
        QVERIFY(bench.session.isPlaying());
        bench.session.pause();
        QCOMPARE(bench.value("damp"), 1.0);
    }

    void theKeyboardGoesThroughTheCards()
    {
        GalleryBench bench;
        bench.open();
        QVERIFY(bench.cards()[0]->hasFocus());
        QTest::keyClick(bench.cards()[0], Qt::Key_Right);
        QVERIFY(bench.cards()[1]->hasFocus());
        QTest::keyClick(bench.cards()[1], Qt::Key_Left);
        QTest::keyClick(bench.cards()[0], Qt::Key_Down);
        QVERIFY(bench.cards()[3]->hasFocus());
        QTest::keyClick(bench.cards()[3], Qt::Key_Right);
        QVERIFY(bench.cards()[3]->hasFocus());
        QTest::keyClick(bench.cards()[3], Qt::Key_Space);
        QCOMPARE(bench.value("k"), 0.3);
    }

    void aPanelThatGoesTakesItsOpenGalleryAlong()
    {
        for (const int focused : {0, 3}) {
            auto bench = std::make_unique<GalleryBench>();
            bench->open();
            bench->cards()[focused]->setFocus();
            bench.reset();
            QVERIFY(!QApplication::activePopupWidget());
            QCoreApplication::processEvents();
        }
    }

    void escapeClosesItAndChangesNothing()
    {
        GalleryBench bench;
        bench.open();
        QTest::keyClick(bench.cards()[0], Qt::Key_Escape);
        QVERIFY(!QApplication::activePopupWidget());
        QCOMPARE(bench.value("k"), 0.2);
    }
};

QTEST_MAIN(TestGallery)
#include "tst_gallery.moc"
