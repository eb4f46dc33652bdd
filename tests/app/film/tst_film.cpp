// Films, read by Qt's readers of GIF and PNG.

#include "tests/app/film/film_support.h"
#include "tests/app/support/session_fixture.h"

#include "app/model/film/gif_file.h"
#include "app/model/text/user_error.h"
#include "app/ui/film/film.h"
#include "tests/suite.h"

#include <QDir>
#include <QTemporaryDir>

using namespace app;
using namespace tests;
using namespace film_support;

namespace {

FilmPlan planOf(const SessionFixture &fixture, const char *lesson, const char *step, const QString &out)
{
    FilmPlan plan;
    plan.experiment = newExperiment(lesson, step, fixture.library);
    plan.out = out;
    plan.size = {320, 240};
    plan.to = 11;
    return plan;
}

void make(const FilmPlan &plan, const LessonLibrary &library)
{
    Film film(plan, library);
    std::int64_t done = 0;
    while (film.goOn()) {
        QCoreApplication::processEvents();
        QVERIFY(film.done() >= done && film.done() <= film.total());
        done = film.done();
    }
    QCOMPARE(film.done(), film.total());
}

}

class FilmTest : public QObject
{
    Q_OBJECT

private slots:
    void aFilmOfFewColorsComesBackExactly();
    void onlyWhatChangedIsWritten();
    void framesOfAGifAreThePicturesOfTheScene_data();
    void framesOfAGifAreThePicturesOfTheScene();
    void aGifLastsAsLongAsItsFrames_data();
    void aGifLastsAsLongAsItsFrames();
    void aFilmFromTheMiddleShowsTheSameFrames();
    void pngFilesAreThePicturesOfTheSceneExactly();
    void invalidFileNameIsRefused_data();
    void invalidFileNameIsRefused();
    void filesInTheWayAreTheOnesThatWouldBeReplaced();
    void makingAFilmTicksNoThingToTry();
    void subjectOfAFilmStaysInThePicture_data();
    void subjectOfAFilmStaysInThePicture();

private:
    QTemporaryDir m_folder;
};

void FilmTest::aFilmOfFewColorsComesBackExactly()
{
    ColorCount count;
    std::vector<QImage> pictures;
    for (int i = 0; i < 9; ++i) {
        QImage picture(97, 61, QImage::Format_RGB32);
        picture.fill(qRgb(250, 251, 252));
        QPainter painter(&picture);
        for (int k = 0; k < 25; ++k)
            painter.fillRect(7 * i + 3 * k, 2 * k, 9, 9, QColor::fromHsv(14 * k, 200, 255 - 20 * i));
        painter.end();
        count.add(picture);
        pictures.push_back(picture);
    }
    const std::vector<QRgb> palette = paletteOf(count, {}, GifFile::mostColors);
    const QString path = m_folder.filePath("few.gif");
    GifFile gif(path, {97, 61}, palette);
    for (const QImage &picture : pictures)
        gif.add(picture, 5);
    QVERIFY(!QFile::exists(path));
    gif.finish();
    const Decoded film = decoded(path);
    QCOMPARE(film.pictures.size(), pictures.size());
    QCOMPARE(film.loops, -1); // for ever
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        QCOMPARE(film.milliseconds[i], 50);
        QCOMPARE(difference(film.pictures[i], pictures[i]).worst, 0);
    }
}

void FilmTest::onlyWhatChangedIsWritten()
{
    QImage picture(400, 300, QImage::Format_RGB32);
    for (int y = 0; y < 300; ++y) {
        for (int x = 0; x < 400; ++x)
            picture.setPixel(x, y, qRgb((x * 37 + y * 91) % 4 * 80, 0, 0)); // does not compress well
    }
    ColorCount count;
    count.add(picture);
    const auto sizeOf = [&](int times) {
        const QString path = m_folder.filePath("changed.gif");
        GifFile gif(path, picture.size(), paletteOf(count, {qRgb(0, 255, 0)}, GifFile::mostColors));
        QImage now = picture;
        for (int i = 0; i < times; ++i) {
            now.setPixel(i, i, qRgb(0, 255, 0));
            gif.add(now, 3);
        }
        gif.finish();
        return QFileInfo(path).size();
    };
    const qint64 one = sizeOf(1);
    QVERIFY(one > 1000);
    const qint64 more = sizeOf(101) - one;
    QVERIFY(more > 100 * 10 && more < 100 * 40);
}

void FilmTest::framesOfAGifAreThePicturesOfTheScene_data()
{
    QTest::addColumn<QByteArray>("lesson");
    QTest::addColumn<QByteArray>("step");
    QTest::addColumn<bool>("dark");
    QTest::addColumn<double>("mean"); ///< 0 to 255, and so is the next
    QTest::addColumn<int>("worst");
    const auto row = [](const char *lesson, const char *step, bool dark, double mean, int worst) {
        QTest::addRow("%s/%s %s", lesson, step, dark ? "dark" : "light")
            << QByteArray(lesson) << QByteArray(step) << dark << mean << worst;
    };
    row("multi_foot", "any_number", false, 0.1, 24);
    row("multi_foot", "any_number", true, 0.1, 24);
    row("walking_gait", "ground", false, 0.1, 24);
    row("rigid_constraint", "ragdoll", true, 0.1, 24);
    row("codeling", "tentacles", false, 0.1, 24);
    row("swaying_tree", "turbulence", true, 1.0, 32); // a sky of many blues
}

void FilmTest::framesOfAGifAreThePicturesOfTheScene()
{
    QFETCH(QByteArray, lesson);
    QFETCH(QByteArray, step);
    QFETCH(bool, dark);
    QFETCH(double, mean);
    QFETCH(int, worst);
    SessionFixture fixture(LessonLibrary::load({LESSON_DIR}));
    FilmPlan plan = planOf(fixture, lesson, step, m_folder.filePath("scene.gif"));
    plan.scheme = dark ? Scheme::dark : Scheme::light;
    make(plan, fixture.library);
    const Decoded film = decoded(plan.out);
    QCOMPARE(film.pictures.size(), std::size_t(12));
    // The reference is a lossless PNG export of the same film.
    plan.out = m_folder.filePath("scene_%d.png");
    make(plan, fixture.library);
    for (int frame = 0; frame < 12; ++frame) {
        const QImage scene(pictureName(plan.out, frame));
        QCOMPARE(scene.size(), plan.size);
        const Difference found = difference(film.pictures[std::size_t(frame)], scene);
        QVERIFY2(
            found.mean <= mean && found.worst <= worst,
            qPrintable(QString("frame %1: mean %2, worst %3").arg(frame).arg(found.mean).arg(found.worst)));
    }
}

void FilmTest::aGifLastsAsLongAsItsFrames_data()
{
    QTest::addColumn<double>("rate");
    for (const double rate : {50.0, 30.0, 12.5, 7.0})
        QTest::addRow("%g a second", rate) << rate;
}

void FilmTest::aGifLastsAsLongAsItsFrames()
{
    QFETCH(double, rate);
    SessionFixture fixture(LessonLibrary::load({LESSON_DIR}));
    FilmPlan plan = planOf(fixture, "single_spring", "radial", m_folder.filePath("long.gif"));
    plan.size = {160, 120};
    plan.to = 59;
    plan.rate = rate;
    make(plan, fixture.library);
    const Decoded film = decoded(plan.out);
    QCOMPARE(film.pictures.size(), std::size_t(60));
    int all = 0;
    for (const int one : film.milliseconds) {
        QVERIFY(one >= 20 && std::abs(one - 1000.0 / rate) < 10.0);
        all += one;
    }
    QVERIFY(std::abs(all - 60 * 1000.0 / rate) <= 5.0); // hundredths of a second, rounded once
}

void FilmTest::aFilmFromTheMiddleShowsTheSameFrames()
{
    SessionFixture fixture(LessonLibrary::load({LESSON_DIR}));
    FilmPlan plan = planOf(fixture, "multi_foot", "two_feet", m_folder.filePath("a_%03d.png"));
    plan.to = 50;
    make(plan, fixture.library);
    plan.out = m_folder.filePath("b_%03d.png");
    plan.from = 42;
    make(plan, fixture.library);
    QVERIFY(!QFile::exists(pictureName(plan.out, 41)));
    for (int frame = 42; frame <= 50; ++frame) {
        const QString name = pictureName(plan.out, frame);
        QVERIFY(name.endsWith(QString("b_0%1.png").arg(frame)));
        QCOMPARE(QImage(name), QImage(m_folder.filePath(QString("a_0%1.png").arg(frame))));
    }
}

void FilmTest::pngFilesAreThePicturesOfTheSceneExactly()
{
    const SessionFixture fixture(LessonLibrary::load({LESSON_DIR}));
    FilmPlan plan = planOf(fixture, "gravity_walls", "gravity", m_folder.filePath("png_%d.png"));
    plan.to = 3;
    make(plan, fixture.library);
    Session session(fixture.library);
    session.open(plan.experiment);
    session.select({});
    SceneView view(session, fixture.theme);
    view.setFixedSize(plan.size);
    view.show();
    for (int frame = 0; frame <= 3; ++frame) {
        const QImage film(pictureName(plan.out, frame));
        QCOMPARE(film.convertToFormat(QImage::Format_RGB32), view.picture());
        session.playback().frameForward();
    }
}

void FilmTest::invalidFileNameIsRefused_data()
{
    QTest::addColumn<QString>("name");
    for (const char *name :
         {"film", "film.mp4", "film.png", "film_%s.png", "film_%d_%d.png", "film_%d.jpg", "%n%04d.png", ""})
        QTest::newRow(*name ? name : "empty") << QString(name);
}

void FilmTest::invalidFileNameIsRefused()
{
    QFETCH(QString, name);
    QVERIFY_THROWS_EXCEPTION(UserError, filmKind(name));
    QCOMPARE(filmKind("a b%.gif"), FilmKind::gif);
    QCOMPARE(filmKind("/100 %/%d/walk_%04d.png"),
             FilmKind::pictures); // a folder may have any name
    QCOMPARE(pictureName("/100 %/%d/walk_%04d.png", 7), QString("/100 %/%d/walk_0007.png"));
    QCOMPARE(pictureName("walk_%04d.PNG", 41), QString("walk_0041.PNG"));
    QCOMPARE(pictureName("walk_%d.png", 12345), QString("walk_12345.png"));
    QCOMPARE(pictureName("walk_%03d.png", 12345), QString("walk_12345.png"));
}

void FilmTest::filesInTheWayAreTheOnesThatWouldBeReplaced()
{
    const QTemporaryDir folder;
    QVERIFY(QDir(folder.path()).mkpath("100%_7.png"));
    for (const char *name : {"walk.gif", "walk_0004.png", "walk_4.png", "walk_0012.png", "walk_12345.png",
                             "walk_-003.png", "walk_004x.png", "walk_0004.PNG", "xwalk_0005.png"}) {
        QFile file(folder.filePath(name));
        QVERIFY(file.open(QFile::WriteOnly));
    }
    const auto in = [&](const char *name, std::int64_t from, std::int64_t to) {
        return filesInTheWay(folder.filePath(name), from, to);
    };
    QCOMPARE(in("walk.gif", 0, 3), QStringList("walk.gif"));
    QCOMPARE(in("new.gif", 0, 3), QStringList());
    QCOMPARE(in("walk_%04d.png", 4, 12), QStringList({"walk_0004.png", "walk_0012.png"}));
    QCOMPARE(in("walk_%04d.png", 5, 11), QStringList());
    QCOMPARE(in("walk_%04d.png", 13, mostFrames), QStringList("walk_12345.png"));
    QCOMPARE(in("walk_%d.png", 0, 12), QStringList("walk_4.png"));
    QCOMPARE(in("nowhere/walk_%d.png", 0, 12), QStringList());
    QCOMPARE(in("100%/_%d.png", 0, 12), QStringList());
    QVERIFY_THROWS_EXCEPTION(UserError, in("walk.mp4", 0, 3));
}

void FilmTest::makingAFilmTicksNoThingToTry()
{
    SessionFixture fixture;
    make(planOf(fixture, "one", "first", m_folder.filePath("done.gif")), fixture.library);
    QVERIFY(!Progress().isDone("one", "first", 0));
    fixture.session.playback().play(); // a run of five frames ticks it
    QTRY_VERIFY(Progress().isDone("one", "first", 0));
}

void FilmTest::subjectOfAFilmStaysInThePicture_data()
{
    QTest::addColumn<QString>("file");
    QTest::addColumn<QSize>("size");
    for (const QSize size : {QSize(640, 480), QSize(640, 360), QSize(300, 300)}) {
        for (const char *name : {"chain", "ragdoll", "jelly", "wheel"})
            QTest::addRow("%s, %d x %d", name, size.width(), size.height())
                << QStringLiteral(":/examples/sandbox/%1.json").arg(name) << size;
    }
}

/// In a film of bodies, sticks and springs only, no picture has ink at its sides or its top, and the largest body has
/// about the same area in all pictures.
void FilmTest::subjectOfAFilmStaysInThePicture()
{
    QFETCH(QString, file);
    QFETCH(QSize, size);
    SessionFixture fixture(LessonLibrary::load({LESSON_DIR}));
    FilmPlan plan;
    plan.experiment = readExperiment(file, fixture.library);
    plan.out = m_folder.filePath("subject_%d.png");
    plan.size = size;
    plan.to = 84;
    plan.extras = Extras{false, false, false, false, false};
    make(plan, fixture.library);
    const QRgb ink = fixture.theme.tokens().body.rgb();
    int first = 0;
    for (int frame = 0; frame <= plan.to; ++frame) {
        const QImage picture = QImage(pictureName(plan.out, frame)).convertToFormat(QImage::Format_RGB32);
        int count = 0;
        for (int y = 0; y < picture.height(); ++y) {
            for (int x = 0; x < picture.width(); ++x) {
                if (picture.pixel(x, y) != ink)
                    continue;
                ++count;
                QVERIFY2(x > 4 && x < picture.width() - 5 && y > 4 && y < picture.height() - 5,
                         qPrintable(QString("frame %1: %2, %3").arg(frame).arg(x).arg(y)));
            }
        }
        if (frame == 0)
            first = count;
        QVERIFY(first > 20);
        QVERIFY2(count > 0.8 * first,
                 qPrintable(QString("frame %1: %2 of %3").arg(frame).arg(count).arg(first)));
    }
}

SUITE(tst_film, FilmTest)
#include "tst_film.moc"
