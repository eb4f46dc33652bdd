#include "app/model/text/accuracy_text.h"
#include "app/ui/accuracy/method_colors.h"
#include "sim/methods/methods.h"
#include "tests/app/cli/program.h"
#include "tests/suite.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QMap>
#include <QProcess>
#include <QRandomGenerator>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>
#include <QXmlStreamReader>

#include <cmath>
#include <sys/types.h>

using namespace program;

namespace {

/// The step's field of a row or reference: "h" or "tolerance", as an experiment has it.
QString stepField(const QJsonObject &row)
{
    const QString name = row.contains("h") ? "h" : "tolerance";
    return QStringLiteral("\"%1\": %2").arg(name, QString::number(row[name].toDouble(), 'g', 17));
}

/// The contents of a plot in an SVG file.
struct SvgContents
{
    QString error; ///< empty for a valid file without places that are not numbers
    QString title;
    QStringList texts;
    QMap<QString, int> pathsByColor; ///< number of paths by the colour of their outlines
    bool hasFront = false;           ///< whether there is a line as wide as that of the front
};

SvgContents readSvg(const QString &path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return {file.errorString(), {}, {}, {}};
    QXmlStreamReader svg(&file);
    SvgContents contents;
    QStringList strokes; // of the open groups
    while (!svg.atEnd()) {
        svg.readNext();
        for (const QXmlStreamAttribute &attribute : svg.attributes()) {
            if (attribute.value().contains(QLatin1String("nan")))
                contents.error = "a place that is not a number";
        }
        if (svg.isEndElement() && svg.name() == QLatin1String("g"))
            strokes.removeLast();
        if (!svg.isStartElement())
            continue;
        if (svg.name() == QLatin1String("g")) {
            strokes << svg.attributes().value("stroke").toString().toLower();
            contents.hasFront =
                contents.hasFront || svg.attributes().value("stroke-width") == QLatin1String("9");
        } else if (svg.name() == QLatin1String("path") && !strokes.isEmpty()) {
            ++contents.pathsByColor[strokes.last()];
        } else if (svg.name() == QLatin1String("title")) {
            contents.title = svg.readElementText();
        } else if (svg.name() == QLatin1String("text")) {
            contents.texts << svg.readElementText();
        }
    }
    if (svg.hasError())
        contents.error = svg.errorString();
    return contents;
}

/// The largest distance between two traces, in px.
double apart(const QString &a, const QString &b)
{
    const QStringList first = a.split('\n', Qt::SkipEmptyParts), second = b.split('\n', Qt::SkipEmptyParts);
    if (first.size() != second.size())
        return HUGE_VAL;
    double largest = 0.0;
    for (qsizetype i = 1; i < first.size(); ++i) {
        const QStringList one = first[i].split(','), other = second[i].split(',');
        if (one.mid(0, 2) != other.mid(0, 2))
            return HUGE_VAL;
        largest = std::max(largest, std::hypot(one[2].toDouble() - other[2].toDouble(),
                                               one[3].toDouble() - other[3].toDouble()));
    }
    return largest;
}

}

/// `springstep accuracy`: its output in all formats.
class TestAccuracyCli : public QObject
{
    Q_OBJECT

private slots:
    void tolerancesAreWrittenInOneWay()
    {
        const Answer answer = springstep({"accuracy", "single_spring/radial", "--frames", "5"});
        QCOMPARE(answer.code, 0);
        QStringList written;
        for (const QString &line : answer.out.split('\n')) {
            if (line.startsWith("dop853"))
                written << line.section("tolerance ", 1).section(' ', 0, 0);
        }
        QCOMPARE(written, QString("1 1e-1 1e-2 1e-3 1e-4 1e-5 1e-6 1e-7 1e-8 1e-9 1e-10").split(' '));
        const QRegularExpression padded("\\de[+-]?0\\d");
        QVERIFY2(!padded.match(answer.out).hasMatch(), qPrintable(answer.out));
    }

    void badUseIsOneSentenceAndExitCode2_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QString>("sentence");
        const auto row = [](const char *name, const QStringList &arguments, const QString &sentence) {
            QTest::newRow(name) << QStringList{"accuracy"} + arguments << sentence;
        };
        row("nothing", {}, "springstep: accuracy takes FILE|LESSON/STEP; see springstep accuracy --help.");
        row("neither file nor step", {"radial"},
            "\"radial\" is neither a file nor a step; name a step as LESSON/STEP, as \"springstep lessons\" "
            "lists them.");
        row("a step that is not there", {"two_body/sideways"},
            "The lesson \"two_body\" has no step \"sideways\"; it has \"mutual\", \"leg_line\".");
        row("a file that is not there", {"runs/walk.springstep"},
            "\"runs/walk.springstep\" is neither a file nor a step; name a step as LESSON/STEP, as "
            "\"springstep lessons\" lists them.");
        row("a picture of another kind", {"two_body/mutual", "--svg", "out.png"},
            "springstep: \"out.png\" is not the name of a plot; it ends in .svg.");
        row("a tolerance of 0", {"two_body/mutual", "--tolerance", "0"},
            "springstep: --tolerance is \"0\"; it can be 1e-12 to 1000000.");
        row("a tolerance in words", {"two_body/mutual", "--tolerance", "small"},
            "springstep: --tolerance is \"small\"; it can be 1e-12 to 1000000.");
        row("no frame", {"two_body/mutual", "--frames", "0"},
            "springstep: --frames is \"0\"; it can be 1 to 10000.");
        row("a picture that cannot be written",
            {"single_spring/radial", "--frames", "2", "--svg", "/none/there.svg"},
            "/none/there.svg: the picture could not be written: No such file or directory. Choose another "
            "folder "
            "or name.");
    }
    void badUseIsOneSentenceAndExitCode2()
    {
        QFETCH(QStringList, arguments);
        QFETCH(QString, sentence);
        const Answer answer = springstep(arguments);
        QCOMPARE(answer.err, sentence + '\n');
        checkRefusal(answer);
    }

    void jsonHasTheDocumentedShape()
    {
        const Answer answer = springstep({"accuracy", "single_spring/radial", "--json", "--frames", "60"});
        QCOMPARE(answer.err, QString());
        QCOMPARE(answer.code, 0);
        const QJsonObject all = json(answer);
        QCOMPARE(all["experiment"].toString(), "single_spring/radial");
        QCOMPARE(all["span_frames"].toInt(), 60);
        QCOMPARE(all["horizon_frames"].toInt(), 60);
        for (const char *field : {"method", "check"})
            QVERIFY(!all["reference"][QLatin1String(field)].toString().isEmpty());
        QVERIFY(all["reference"]["method"] != all["reference"]["check"]);
        const double disagreement = all["reference"]["disagreement"].toDouble(-1.0);
        QVERIFY(disagreement >= 0.0 && disagreement < 1e-8);
        int measured = 0;
        for (const QJsonValue &value : all["rows"].toArray()) {
            const QJsonObject row = value.toObject();
            QVERIFY(row.contains("h") != row.contains("tolerance"));
            QVERIFY(row["order"].toInt() >= 1 && row["front"].isBool());
            if (row["status"].toString() != "measured")
                continue;
            ++measured;
            for (const char *field : {"error", "evaluations", "ns_per_frame", "spread"})
                QVERIFY2(row[QLatin1String(field)].isDouble(), field);
            QVERIFY(row["ns_per_frame"].toDouble() > 0.0 && row["evaluations"].toDouble() > 0.0);
        }
        QVERIFY(measured > 30);
        checkCheapest(all);
    }

    void aRowIsReproducedByTrace()
    {
        const int frames = 40;
        const QJsonObject all =
            json(springstep({"accuracy", file("\"method\": \"published\"", frames), "--json"}));
        QCOMPARE(all["horizon_frames"].toInt(), frames);
        const auto trace = [&](const QString &method, const QJsonObject &step) {
            return springstep(
                       {"trace",
                        file(QStringLiteral("\"method\": \"%1\", ").arg(method) + stepField(step), frames)})
                .out;
        };
        const QJsonObject reference = all["reference"].toObject();
        const QString truth = trace(reference["method"].toString(), reference["step"].toObject());
        QRandomGenerator dice(7);
        const QJsonArray rows = all["rows"].toArray();
        for (int checked = 0; checked < 10;) {
            const QJsonObject row = rows[dice.bounded(int(rows.size()))].toObject();
            if (row["status"].toString() != "measured")
                continue;
            ++checked;
            const double off = apart(trace(row["method"].toString(), row), truth);
            const double error = row["error"].toDouble();
            QVERIFY2(std::abs(off - error) <= 1e-12 + 1e-9 * error,
                     qPrintable(row["method"].toString() + ' ' + stepField(row)));
        }
    }

    void exitCodeTellsWhetherTheToleranceIsMet()
    {
        const Answer near = springstep(
            {"accuracy", "single_spring/radial", "--frames", "30", "--tolerance", "0.5", "--json"});
        QCOMPARE(near.code, 0);
        QVERIFY(json(near).value("within").toObject().value("error").toDouble(9.0) <= 0.5);
        const Answer never = springstep(
            {"accuracy", "single_spring/radial", "--frames", "30", "--tolerance", "1e-12", "--json"});
        QVERIFY(json(never).value("within").isNull());
        QCOMPARE(never.code, 1);
        const Answer words =
            springstep({"accuracy", "single_spring/radial", "--frames", "30", "--tolerance", "0.5"});
        QVERIFY2(words.out.contains("The cheapest way to stay within an error of 0.5 px costs "),
                 qPrintable(words.out));
        QVERIFY(words.out.contains("The method in use, published, h 1, costs "));
    }

    void aSceneWithoutAContinuousLimitSaysSo()
    {
        const QStringList arguments = {"accuracy", "rigid_constraint/verlet", "--frames", "10"};
        const Answer answer = springstep(arguments);
        QCOMPARE(answer.code, 0);
        QVERIFY2(answer.out.contains("This scene has no exact motion to compare with, because "),
                 qPrintable(answer.out));
        const QJsonObject all = json(springstep(arguments + QStringList{"--json"}));
        QCOMPARE(all["reference"]["method"].toString(), "own_refinement");
        QVERIFY(!all["reference"].toObject().value("no_limit").toString().isEmpty());
        int unfit = 0;
        for (const QJsonValue &row : all["rows"].toArray()) {
            if (row["status"].toString() != "does_not_fit")
                continue;
            ++unfit;
            QVERIFY(row["reason"].toString().endsWith('.') && row["error"].isNull());
        }
        QVERIFY(unfit > 0);
    }

    void theSvgShowsEveryMethodThatWasMeasured()
    {
        const QString path = m_folder.filePath("plot.svg");
        const Answer answer =
            springstep({"accuracy", "single_spring/radial", "--frames", "20", "--json", "--svg", path});
        QCOMPARE(answer.code, 0);
        QMap<QString, int> measured; // number of rows by method
        for (const QJsonValue &row : json(answer)["rows"].toArray()) {
            if (row["status"].toString() == "measured")
                ++measured[row["method"].toString()];
        }
        QVERIFY(measured.size() > 5);
        const SvgContents svg = readSvg(path);
        QCOMPARE(svg.error, QString());
        QVERIFY2(svg.title.startsWith("single_spring/radial: 20 frames; reference "), qPrintable(svg.title));
        const app::Theme theme(app::Scheme::light);
        for (const sim::MethodPtr &method : sim::allMethods()) {
            const QString id = QString::fromStdString(method->id());
            if (!measured.contains(id))
                continue;
            QVERIFY2(svg.texts.contains(app::methodTitle(*method)), qPrintable(id));
            const QString color = app::inkOf(*method, theme).color.name();
            QVERIFY2(svg.pathsByColor.value(color) >= measured[id], qPrintable(id)); // a marker per row
        }
        QVERIFY(svg.hasFront);
        for (const char *words : {"largest error, px", "time to compute a frame, µs", "you are here"})
            QVERIFY2(svg.texts.contains(QString::fromUtf8(words)), words);
    }

    void interruptingStopsCleanly()
    {
        QProcess process;
        process.setProcessEnvironment(bareEnvironment());
        process.start(PROGRAM, {"accuracy", "swaying_tree/real_sway"});
        QVERIFY(process.waitForStarted());
        QVERIFY(interrupt(process)); // what it computes takes many seconds
        QCOMPARE(process.exitCode(), 130);
        QCOMPARE(QString::fromUtf8(process.readAllStandardOutput()), QString());
        QCOMPARE(QString::fromUtf8(process.readAllStandardError()), QString("Stopped before the end.\n"));
    }

private:
    /// Checks that each answer to "which is the cheapest" follows from the rows.
    static void checkCheapest(const QJsonObject &all)
    {
        const QJsonObject cheapest = all["cheapest"].toObject();
        QCOMPARE(cheapest.size(), 8);
        for (const QString &within : cheapest.keys()) {
            double least = HUGE_VAL;
            for (const QJsonValue &row : all["rows"].toArray()) {
                if (row["status"].toString() == "measured" && row["error"].toDouble() <= within.toDouble())
                    least = std::min(least, row["ns_per_frame"].toDouble());
            }
            if (least == HUGE_VAL)
                QVERIFY(cheapest[within].isNull());
            else
                QCOMPARE(cheapest[within]["ns_per_frame"].toDouble(), least);
        }
    }

    QString file(const QString &fields, int frames) const
    {
        return fileWith(m_folder.path(),
                        QStringLiteral("\"parameters\": {\"feet\": 3}, \"bodies\": {\"foot0\": {\"x\": 300, "
                                       "\"y\": 280}, \"foot1\": {\"x\": 200, \"y\": 180}, \"foot2\": {\"x\": "
                                       "330, \"y\": 170}}, \"frames\": %1, %2")
                            .arg(frames)
                            .arg(fields));
    }

    QTemporaryDir m_folder;
};

SUITE(tst_accuracy_cli, TestAccuracyCli)
#include "tst_accuracy_cli.moc"
