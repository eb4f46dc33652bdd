// Films as video, read by other libraries: one picture per frame of the run, at its time, as the scene shows it.

#include "tests/app/film/film_support.h"
#include "tests/app/film/webm_reader.h"
#include "tests/app/support/session_fixture.h"

#include "app/model/film/film_file.h"
#include "app/model/film/webm_file.h"
#include "app/ui/film/film.h"
#include "tests/suite.h"

#include <QTemporaryDir>

using namespace app;
using namespace tests;

namespace {

FilmPlan videoPlan(const SessionFixture &fixture, const QString &out)
{
    FilmPlan plan;
    plan.experiment = newExperiment("multi_foot", "any_number", fixture.library);
    plan.out = out;
    plan.size = {321, 239}; // the last column and row are half a square
    plan.to = 20;
    return plan;
}

void makeVideo(const FilmPlan &plan, const LessonLibrary &library)
{
    Film film(plan, library);
    while (film.goOn())
        QCoreApplication::processEvents();
    QCOMPARE(film.done(), film.total());
}

/// Returns a picture with many different colours.
QImage colourful(QSize size, int number)
{
    QImage picture(size, QImage::Format_RGB32);
    picture.fill(QColor::fromHsv(37 * number % 360, 120, 220));
    QPainter painter(&picture);
    for (int i = 0; i < 12; ++i)
        painter.fillRect(16 * i, 8 * ((i + number) % 9), 16, 24, QColor::fromHsv(30 * i, 255, 255));
    return picture;
}

}

class VideoTest : public QObject
{
    Q_OBJECT

private slots:
    void eachFrameIsAPictureOfTheScene()
    {
        SessionFixture fixture(LessonLibrary::load({LESSON_DIR}));
        FilmPlan plan = videoPlan(fixture, m_folder.filePath("a_%d.png"));
        makeVideo(plan, fixture.library);
        plan.out = m_folder.filePath("a.webm");
        makeVideo(plan, fixture.library);
        const webm_reader::Film film = webm_reader::read(plan.out);
        QCOMPARE(film.fault, QString());
        QCOMPARE(film.pictures.size(), std::size_t(21));
        QImage before;
        for (std::size_t i = 0; i < film.pictures.size(); ++i) {
            const QImage picture(m_folder.filePath(QString("a_%1.png").arg(i)));
            QCOMPARE(film.pictures[i].size(), picture.size());
            const double apart = film_support::difference(film.pictures[i], picture).mean;
            QVERIFY2(apart < 1.5, qPrintable(QString::number(apart)));
            // No picture is one frame late: the frame before differs more. Later the run is almost at rest.
            if (i > 0 && i < 8)
                QVERIFY(film_support::difference(film.pictures[i], before).mean > apart);
            before = picture;
        }
    }

    void coloursSurviveEncoding()
    {
        const QString path = m_folder.filePath("b.webm");
        WebmFile file(path, {192, 96});
        for (int i = 0; i < 5; ++i)
            file.add(colourful({192, 96}, i), 40 * (i + 1));
        QVERIFY(!QFile::exists(path));
        file.finish();
        const webm_reader::Film film = webm_reader::read(path);
        QCOMPARE(film.fault, QString());
        QCOMPARE(film.pictures.size(), std::size_t(5));
        for (int i = 0; i < 5; ++i) {
            const QImage wanted = colourful({192, 96}, i);
            for (int k = 0; k < 12; ++k) { // the middle of each rectangle
                const QPoint at(16 * k + 8, 8 * ((k + i) % 9) + 12);
                const QColor is = film.pictures[std::size_t(i)].pixelColor(at), was = wanted.pixelColor(at);
                QVERIFY2(std::abs(is.red() - was.red()) < 12 && std::abs(is.green() - was.green()) < 12 &&
                             std::abs(is.blue() - was.blue()) < 12,
                         qPrintable(is.name() + " for " + was.name()));
            }
        }
    }

    void eachFrameHasItsTime_data()
    {
        QTest::addColumn<double>("rate");
        QTest::newRow("as the window plays") << 30.0;
        QTest::newRow("fast") << 120.0;
        QTest::newRow("slow") << 0.1; // a minute has to be cut
    }
    void eachFrameHasItsTime()
    {
        QFETCH(double, rate);
        SessionFixture fixture(LessonLibrary::load({LESSON_DIR}));
        FilmPlan plan = videoPlan(fixture, m_folder.filePath("c.webm"));
        plan.rate = rate;
        makeVideo(plan, fixture.library);
        const webm_reader::Film film = webm_reader::read(plan.out);
        QCOMPARE(film.fault, QString());
        QCOMPARE(film.times.size(), std::size_t(21));
        for (std::size_t i = 0; i < film.times.size(); ++i)
            QCOMPARE(film.times[i], std::llround(1000.0 * double(i) / rate));
        QCOMPARE(film.duration, double(std::llround(21'000.0 / rate)));
    }

    void playerCanSeekInTheWholeVideo()
    {
        const QString path = m_folder.filePath("d.webm");
        WebmFile file(path, {64, 48});
        for (int i = 0; i < 400; ++i)
            file.add(colourful({64, 48}, i / 10), 40 * (i + 1));
        file.finish();
        const webm_reader::Film film = webm_reader::read(path);
        QCOMPARE(film.fault, QString());
        QCOMPARE(film.pictures.size(), std::size_t(400));
        QVERIFY(film.keys.front());
        QVERIFY(film.cues.size() >= 3);
        QCOMPARE(film.cuePositions, film.clusters);
        for (const std::int64_t time : film.cues) {
            const auto at = std::find(film.times.begin(), film.times.end(), time);
            QVERIFY(at != film.times.end() && film.keys[std::size_t(at - film.times.begin())]);
        }
    }

    void aCancelledVideoLeavesNoFile()
    {
        SessionFixture fixture(LessonLibrary::load({LESSON_DIR}));
        const FilmPlan plan = videoPlan(fixture, m_folder.filePath("e.webm"));
        {
            Film film(plan, fixture.library);
            while (film.done() < 5 && film.goOn())
                QCoreApplication::processEvents();
            QVERIFY(film.done() >= 5);
        }
        QCOMPARE(QDir(m_folder.path()).entryList({"e.webm*"}), QStringList());
    }

private:
    QTemporaryDir m_folder;
};

SUITE(tst_video, VideoTest)
#include "tst_video.moc"
