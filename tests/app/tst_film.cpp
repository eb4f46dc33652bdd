// Pictures and films, read by others' code: Qt's readers of GIF, PNG and SVG.

#include "window_bench.h"

#include "app/model/gif_file.h"
#include "app/model/refusal.h"
#include "app/ui/film/film_dialog.h"

#include <QClipboard>
#include <QComboBox>
#include <QDir>
#include <QImageReader>
#include <QLineEdit>
#include <QProgressBar>
#include <QSpinBox>
#include <QSvgRenderer>
#include <QTemporaryDir>

#include <array>

using namespace app;
using window_bench::Bench;

namespace {

struct Decoded
{
    std::vector<QImage> pictures;
    std::vector<int> milliseconds;
    int loops = 0;
};

Decoded decoded(const QString &path)
{
    Decoded film;
    QImageReader reader(path);
    film.loops = reader.loopCount();
    for (QImage picture = reader.read(); !picture.isNull(); picture = reader.read()) {
        film.pictures.push_back(picture.convertToFormat(QImage::Format_RGB32));
        film.milliseconds.push_back(reader.nextImageDelay());
    }
    return film;
}

struct Difference
{
    double mean = 0.0; ///< of all channels of all pixels
    int worst = 0;
};

Difference difference(const QImage &a, const QImage &b)
{
    Difference found;
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) {
            const QRgb one = a.pixel(x, y), two = b.pixel(x, y);
            for (const int by : {qRed(one) - qRed(two), qGreen(one) - qGreen(two), qBlue(one) - qBlue(two)}) {
                found.mean += std::abs(by);
                found.worst = std::max(found.worst, std::abs(by));
            }
        }
    }
    found.mean /= 3.0 * a.width() * a.height();
    return found;
}

FilmPlan planOf(const Bench &bench, const char *lesson, const char *step, const QString &out)
{
    FilmPlan plan;
    plan.experiment = newExperiment(lesson, step, bench.library);
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
    void initTestCase() { window_bench::keepSettingsIn(m_folder.path()); }
    void aFilmOfFewColorsComesBackExactly();
    void onlyWhatChangedIsWritten();
    void framesOfAGifAreThePicturesOfTheScene_data();
    void framesOfAGifAreThePicturesOfTheScene();
    void aGifLastsAsLongAsItsFrames_data();
    void aGifLastsAsLongAsItsFrames();
    void aFilmFromTheMiddleShowsTheSameFrames();
    void pngFilesAreThePicturesOfTheSceneExactly();
    void aNameThatIsNoFilmsIsRefused_data();
    void aNameThatIsNoFilmsIsRefused();
    void makingAFilmGetsNothingDone();
    void theDialogMakesAFilmWhileTheWindowGoesOn();
    void aFilmThatIsStoppedLeavesNoFile();
    void aFolderThatIsNotThereIsSaid();
    void thePictureIsCopiedAndSaved();
    void theSvgLooksAsThePictureDoes_data();
    void theSvgLooksAsThePictureDoes();

private:
    FilmDialog &openDialog(Bench &bench);
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
    QVERIFY(sizeOf(101) - one < 100 * 40);
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
    Bench bench;
    FilmPlan plan = planOf(bench, lesson, step, m_folder.filePath("scene.gif"));
    plan.scheme = dark ? Scheme::dark : Scheme::light;
    make(plan, bench.library);
    const Decoded film = decoded(plan.out);
    QCOMPARE(film.pictures.size(), std::size_t(12));
    // The truth: PNG files of the same film, which lose nothing.
    plan.out = m_folder.filePath("scene_%d.png");
    make(plan, bench.library);
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
    Bench bench;
    FilmPlan plan = planOf(bench, "single_spring", "radial", m_folder.filePath("long.gif"));
    plan.size = {160, 120};
    plan.to = 59;
    plan.rate = rate;
    make(plan, bench.library);
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
    Bench bench;
    FilmPlan plan = planOf(bench, "multi_foot", "two_feet", m_folder.filePath("a_%03d.png"));
    plan.to = 50;
    make(plan, bench.library);
    plan.out = m_folder.filePath("b_%03d.png");
    plan.from = 42;
    make(plan, bench.library);
    QVERIFY(!QFile::exists(pictureName(plan.out, 41)));
    for (int frame = 42; frame <= 50; ++frame) {
        const QString name = pictureName(plan.out, frame);
        QVERIFY(name.endsWith(QString("b_0%1.png").arg(frame)));
        QCOMPARE(QImage(name), QImage(m_folder.filePath(QString("a_0%1.png").arg(frame))));
    }
}

void FilmTest::pngFilesAreThePicturesOfTheSceneExactly()
{
    Bench bench("gravity_walls", "gravity");
    FilmPlan plan = planOf(bench, "gravity_walls", "gravity", m_folder.filePath("png_%d.png"));
    plan.size = bench.view.viewport()->size();
    plan.to = 3;
    make(plan, bench.library);
    for (int frame = 0; frame <= 3; ++frame) {
        const QImage film(pictureName(plan.out, frame));
        QCOMPARE(film.convertToFormat(QImage::Format_RGB32), bench.view.picture());
        bench.press(Qt::Key_Right, {});
    }
}

void FilmTest::aNameThatIsNoFilmsIsRefused_data()
{
    QTest::addColumn<QString>("name");
    for (const char *name :
         {"film", "film.mp4", "film.png", "film_%s.png", "film_%d_%d.png", "film_%d.jpg", "%n%04d.png", ""})
        QTest::newRow(*name ? name : "empty") << QString(name);
}

void FilmTest::aNameThatIsNoFilmsIsRefused()
{
    QFETCH(QString, name);
    QVERIFY_EXCEPTION_THROWN(filmKind(name), Refusal);
    QCOMPARE(filmKind("a b%.gif"), FilmKind::gif);
    QCOMPARE(pictureName("walk_%04d.PNG", 41), QString("walk_0041.PNG"));
    QCOMPARE(pictureName("walk_%d.png", 12345), QString("walk_12345.png"));
    QCOMPARE(pictureName("walk_%03d.png", 12345), QString("walk_12345.png"));
}

void FilmTest::makingAFilmGetsNothingDone()
{
    Bench bench;
    for (const LessonEntry &lesson : bench.library.lessons) {
        if (lesson.id != "gravity_walls")
            continue;
        FilmPlan plan = planOf(bench, "gravity_walls", "gravity", m_folder.filePath("done.gif"));
        plan.size = {120, 100};
        plan.to = 200;
        make(plan, bench.library);
    }
    QVERIFY(QSettings().value("progress/done").toStringList().isEmpty());
}

FilmDialog &FilmTest::openDialog(Bench &bench)
{
    bench.press(Qt::Key_F, Qt::ControlModifier | Qt::ShiftModifier);
    return *bench.window.findChild<FilmDialog *>();
}

void FilmTest::theDialogMakesAFilmWhileTheWindowGoesOn()
{
    Bench bench("multi_foot", "two_feet");
    bench.drag("foot0", {30, 10});
    bench.session.goTo({40, 0});
    FilmDialog &dialog = openDialog(bench);
    QVERIFY(dialog.isVisible() && !dialog.isModal());
    const QString path = m_folder.filePath("dialog.gif");
    const auto boxes = dialog.findChildren<QSpinBox *>();
    QCOMPARE(boxes.at(1)->value(), 40);
    boxes.at(0)->setFocus();
    boxes.at(0)->selectAll();
    QTest::keyClicks(boxes.at(0), "5");
    auto *file = dialog.findChild<QLineEdit *>(QString(), Qt::FindDirectChildrenOnly);
    for (QLineEdit *one : dialog.findChildren<QLineEdit *>()) {
        if (one->accessibleName() == "File")
            file = one;
    }
    file->selectAll();
    QTest::keyClicks(file, path);
    dialog.findChild<QComboBox *>()->setCurrentIndex(0);
    QTest::keyClick(file, Qt::Key_Return);
    QVERIFY(dialog.isMaking());
    bench.session.openStep("single_spring", "drag"); // whatever the window shows meanwhile
    QTRY_VERIFY(!dialog.isMaking());
    QVERIFY2(dialog.said().startsWith("dialog.gif is made"), qPrintable(dialog.said()));
    const Decoded film = decoded(path);
    QCOMPARE(film.pictures.size(), std::size_t(36));
    QCOMPARE(film.pictures.front().size(), QSize(320, 240));
}

void FilmTest::aFilmThatIsStoppedLeavesNoFile()
{
    Bench bench("multi_foot", "two_feet");
    bench.session.goTo({300, 0});
    FilmDialog &dialog = openDialog(bench);
    const QString path = m_folder.filePath("stopped.gif");
    for (QLineEdit *one : dialog.findChildren<QLineEdit *>()) {
        if (one->accessibleName() == "File")
            one->setText(path);
    }
    QTest::keyClick(&dialog, Qt::Key_Return);
    auto *bar = dialog.findChild<QProgressBar *>();
    QTRY_VERIFY(bar->value() > bar->maximum() / 5);
    QVERIFY(dialog.isMaking());
    QTest::keyClick(&dialog, Qt::Key_Escape);
    QVERIFY(!dialog.isMaking());
    QVERIFY(dialog.said().startsWith("Stopped."));
    QCOMPARE(QDir(m_folder.path()).entryList({"stopped*"}), QStringList());
}

void FilmTest::aFolderThatIsNotThereIsSaid()
{
    Bench bench;
    FilmDialog &dialog = openDialog(bench);
    for (QLineEdit *one : dialog.findChildren<QLineEdit *>()) {
        if (one->accessibleName() == "File")
            one->setText(m_folder.filePath("nowhere/film.gif"));
    }
    QTest::keyClick(&dialog, Qt::Key_Return);
    QTRY_VERIFY(!dialog.isMaking());
    QVERIFY2(dialog.said().contains("cannot be written"), qPrintable(dialog.said()));
}

void FilmTest::thePictureIsCopiedAndSaved()
{
    Bench bench;
    bench.press(Qt::Key_P, Qt::ControlModifier | Qt::ShiftModifier);
    const QImage copied = QGuiApplication::clipboard()->image();
    QCOMPARE(copied.size(), 2 * bench.view.viewport()->size());
    const QString path = m_folder.filePath("scene.png");
    QVERIFY(bench.window.savePictureAs(path));
    QCOMPARE(difference(QImage(path), copied).worst, 0);
    QVERIFY(!bench.window.savePictureAs(m_folder.filePath("nowhere/scene.png")));
    QVERIFY(bench.notice.sentence().startsWith("Picture not saved: "));
}

void FilmTest::theSvgLooksAsThePictureDoes_data()
{
    QTest::addColumn<QByteArray>("lesson");
    QTest::addColumn<QByteArray>("step");
    QTest::newRow("creature") << QByteArray("multi_foot") << QByteArray("any_number");
    QTest::newRow("walker") << QByteArray("walking_gait") << QByteArray("ground");
    QTest::newRow("codeling") << QByteArray("codeling") << QByteArray("tentacles");
    QTest::newRow("tree") << QByteArray("swaying_tree") << QByteArray("turbulence");
}

void FilmTest::theSvgLooksAsThePictureDoes()
{
    QFETCH(QByteArray, lesson);
    QFETCH(QByteArray, step);
    Bench bench(lesson, step);
    bench.session.goTo({20, 0});
    const QString path = m_folder.filePath("scene.svg");
    QVERIFY(bench.window.savePictureAs(path));
    QSvgRenderer svg(path);
    QVERIFY(svg.isValid());
    QImage drawn(bench.view.viewport()->size(), QImage::Format_RGB32);
    drawn.fill(Qt::white);
    QPainter painter(&drawn);
    svg.render(&painter);
    painter.end();
    const Difference found = difference(drawn, bench.view.picture());
    QVERIFY2(found.mean < 2.0, qPrintable(QString::number(found.mean)));
}

QTEST_MAIN(FilmTest)
#include "tst_film.moc"
