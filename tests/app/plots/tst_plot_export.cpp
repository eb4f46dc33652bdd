// Saving and copying of plots.

#include "tests/app/plots/plots_panel_support.h"
#include "tests/suite.h"

#include <QClipboard>
#include <QDir>
#include <QPainter>
#include <QSvgRenderer>

using namespace app;
using namespace tests;
using plots_panel_support::PlotsFixture;

class PlotExportTest : public QObject
{
    Q_OBJECT

private slots:
    void picturesAreSavedInEachForm_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QByteArray>("begins");
        QTest::newRow("PNG") << "a.png" << QByteArray("\x89PNG");
        QTest::newRow("SVG") << "a.svg" << QByteArray("<?xml");
        QTest::newRow("PDF") << "a.PDF" << QByteArray("%PDF");
        QTest::newRow("none") << "a" << QByteArray("\x89PNG");
    }

    void picturesAreSavedInEachForm()
    {
        QFETCH(QString, name);
        QFETCH(QByteArray, begins);
        PlotsFixture fixture;
        fixture.goTo(60);
        const QTemporaryDir folder;
        PlotExport &exports = fixture.panel.cards()[0]->exports();
        QSignalSpy said(&fixture.session.changes(), &ChangeNotifier::messageRequested);
        QVERIFY(exports.savePicture(folder.filePath(name)));
        QCOMPARE(said.size(), 1);
        const QStringList files = QDir(folder.path()).entryList(QDir::Files);
        QCOMPARE(files.size(), 1);
        QFile file(folder.filePath(files.front()));
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray bytes = file.readAll();
        QVERIFY(bytes.startsWith(begins));
        QVERIFY(bytes.size() > 2000);
        if (name != "a.svg")
            return;
        QSvgRenderer renderer(bytes);
        QVERIFY(renderer.isValid());
        QImage image(renderer.defaultSize(), QImage::Format_RGB32);
        QPainter painter(&image);
        renderer.render(&painter);
        painter.end();
        QVERIFY(fixture.pixels(fixture.theme.tokens().now, image) > 20);
    }

    void theSuggestedNameIsThatOfTheQuantity()
    {
        PlotsFixture fixture;
        QCOMPARE(fixture.plot().picture().fileName, QString("y-foot"));
    }

    void aPictureThatCannotBeWrittenIsSaidInASentence()
    {
        PlotsFixture fixture;
        fixture.goTo(10);
        QSignalSpy failed(&fixture.panel, &PlotsPanel::failed);
        QVERIFY(!fixture.panel.cards()[0]->exports().savePicture("/no/such/folder/a.png"));
        QCOMPARE(failed.size(), 1);
        QVERIFY(failed[0][0].toString().startsWith("Could not save the picture as \"a.png\""));
    }

    void aPictureIsCopied()
    {
        PlotsFixture fixture;
        fixture.goTo(60);
        QGuiApplication::clipboard()->clear();
        fixture.panel.cards()[0]->exports().copyPicture();
        QVERIFY(QGuiApplication::clipboard()->image().width() >= 2 * fixture.plot().width());
    }

    void numbersAreSavedWithTheirUnits()
    {
        PlotsFixture fixture;
        fixture.panel.add({{QuantityKind::velocityY}, {QuantityKind::placeY}});
        fixture.goTo(50);
        const QTemporaryDir folder;
        QSignalSpy said(&fixture.session.changes(), &ChangeNotifier::messageRequested);
        fixture.panel.cards()[1]->exports().saveNumbers(folder.filePath("a.csv"));
        QTRY_COMPARE(said.size(), 1);
        QFile file(folder.filePath("a.csv"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QStringList lines = QString::fromUtf8(file.readAll()).trimmed().split('\n');
        QCOMPARE(lines.size(), 52);
        QCOMPARE(lines[0], QString("\"frame\",\"y(foot) [px]\",\"velocity_y(foot) [px/frame]\""));
        const sim::State state = fixture.session.timeline().track().stateAt(50);
        QCOMPARE(lines[51].split(',')[1].toDouble(), state.positionOf(0).y);
        QCOMPARE(lines[51].split(',')[2].toDouble(), state.velocityOf(0).y);
    }

    void removingAPlotCancelsItsExport()
    {
        PlotsFixture fixture;
        fixture.goTo(20'000); // so that they are not written at once
        const QTemporaryDir folder;
        QSignalSpy said(&fixture.session.changes(), &ChangeNotifier::messageRequested);
        PlotCard *card = fixture.panel.cards()[0];
        card->exports().saveNumbers(folder.filePath("a.csv"));
        QVERIFY(card->exports().table());
        emit card->removalWanted();
        QTRY_VERIFY(fixture.panel.cards().empty());
        QCOMPARE(said.size(), 1);
        QVERIFY(said[0][0].toString().startsWith("Cancelled"));
        QVERIFY(QDir(folder.path()).isEmpty());
    }
};

SUITE(tst_plot_export, PlotExportTest)
#include "tst_plot_export.moc"
