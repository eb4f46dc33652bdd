// The learner's code in experiment files, in shared text and on the command line.

#include "app/listing/limits.h"
#include "app/model/experiment/experiment_line.h"
#include "app/model/files/autosave.h"
#include "app/model/files/document.h"
#include "app/model/run/run_program.h"
#include "app/model/run/same_run.h"
#include "tests/app/cli/program.h"
#include "tests/app/experiment/experiment_support.h"
#include "tests/app/experiment/user_errors.h"
#include "tests/app/listing/code_session.h"
#include "tests/app/support/files.h"
#include "tests/suite.h"

#include <QDir>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>

using namespace app;
using code_session::Opened;
using experiment_support::library;

namespace {

/// A text with everything that JSON has to escape.
QString strangeText(const Opened &opened)
{
    return opened.listing() + "// \"quoted\" \\ ä → \t end\n";
}

/// Returns a JSON text as it stands in a file.
QByteArray inQuotes(const QString &text)
{
    QByteArray list = QJsonDocument(QJsonObject{{"x", text}}).toJson(QJsonDocument::Compact);
    return list.mid(5).chopped(1);
}

}

class ListingFileTest : public QObject
{
    Q_OBJECT

private slots:
    void codeSurvivesARoundTrip()
    {
        Opened opened("single_spring", "radial");
        Session &session = opened.session;
        session.input().grab("foot");
        session.input().moveTo({100, 300});
        opened.goTo(40);
        session.code().write(Opened::with(strangeText(opened), "*= damp", "*= 0.5"));
        opened.waitUntilThere();
        const Experiment saved = session.experiment();
        experiment_support::compareAfterRoundTrip(saved);
        const Experiment back = parseExperiment(experimentText(saved, library()), "x.json", library());
        QVERIFY(sameScript(back.script, saved.script));
        QVERIFY(!back.draft);

        Opened other("single_spring", "drag");
        other.session.open(back);
        other.goTo(40);
        QCOMPARE(other.session.code().text(), session.code().text());
        QVERIFY(other.session.code().isRunning());
        QVERIFY(sim::sameBits(other.session.timeline().state(), session.timeline().state()));
    }

    void draftSurvivesARoundTrip()
    {
        Opened opened("single_spring", "radial");
        Session &session = opened.session;
        session.code().write(Opened::with(opened.listing(), "*= damp", "*= 0.5"));
        session.code().write(strangeText(opened) + "void broken(");
        const Experiment saved = session.experiment();
        QVERIFY(saved.draft);
        const QByteArray text = experimentText(saved, library());
        QVERIFY(text.contains("\"code\": ") && text.contains("\"draft\": "));
        const Experiment back = parseExperiment(text, "x.json", library());
        QCOMPARE(back.draft, saved.draft);
        QCOMPARE(experimentText(back, library()), text);
        Opened other("single_spring", "drag");
        other.session.open(back);
        QCOMPARE(other.session.code().text(), session.code().text());
        QVERIFY(!other.session.code().mistakes().empty());
    }

    void anUntouchedListingIsNotWritten()
    {
        Opened opened("single_spring", "radial");
        const QByteArray text = experimentText(opened.session.experiment(), library());
        QVERIFY(!text.contains("code") && !text.contains("draft") && !text.contains("method"));
    }

    void sharedTextHasTheCode()
    {
        Opened opened("single_spring", "radial");
        opened.session.code().write(Opened::with(strangeText(opened), "*= damp", "*= 0.5"));
        const Experiment saved = opened.session.experiment();
        const Experiment back = experimentFromLine(experimentLine(saved, library()), library());
        QVERIFY(sameScript(back.script, saved.script));
    }

    void branchesKeepTheirCode()
    {
        Opened opened("single_spring", "radial");
        Session &session = opened.session;
        opened.goTo(10);
        const QString first = Opened::with(opened.listing(), "*= damp", "*= 0.5");
        session.code().write(first);
        opened.waitUntilThere();
        session.editor().endGesture();
        session.code().write(Opened::with(opened.listing(), "*= damp", "*= 0.25"));
        opened.waitUntilThere();
        session.comparisons().keep(session.comparisons().branches().all().back().id, true);
        const QByteArray text = experimentText(session.experiment(), library());
        const Experiment back = parseExperiment(text, "x.json", library());
        QCOMPARE(back.branches.all().size(), std::size_t(1));
        const auto program = programOf(back.branches.all().front().script->method);
        QVERIFY(program);
        QCOMPARE(QString::fromStdString(program->text()), first);
        QVERIFY(sameMarked(back.branches, session.experiment().branches));
    }

    void scriptsDifferByTheirText()
    {
        Opened opened("single_spring", "radial");
        opened.session.code().write(Opened::with(opened.listing(), "*= damp", "*= 0.5"));
        const sim::Script first = opened.session.timeline().script();
        opened.session.code().write(Opened::with(opened.listing(), "*= damp", "*= 0.25"));
        const sim::Script second = opened.session.timeline().script();
        QVERIFY(!sameRun(first, second));
        QVERIFY(sameRun(first, first));
        QVERIFY(!sameRun(first, opened.session.step().script()));
    }

    void aWrongListingFileIsRefusedWithTheLine_data()
    {
        user_errors::addColumns();
        const auto row = [](const char *name, const QByteArray &fields, const QString &sentence) {
            QTest::newRow(name) << user_errors::with(fields) << sentence;
        };
        row("no code", "\"method\": \"listing\"",
            "line 5: the method \"listing\" needs \"code\", the text of a listing.");
        row("code of another method", "\"method\": \"rk4\",\n\"code\": \"void frame() {}\"",
            "line 6: \"code\" needs the method \"listing\"; set \"method\" to it, or remove \"code\".");
        row("code without a method", "\"code\": \"void frame() {}\"",
            "line 5: \"code\" needs the method \"listing\"; set \"method\" to it, or remove \"code\".");
        row("a number", "\"method\": \"listing\",\n\"code\": 7",
            "line 6: \"code\" is 7; it must be a text in double quotes.");
        row("too long", "\"method\": \"listing\",\n\"code\": \"" + QByteArray(20'001, ' ') + "\"",
            "line 6: \"code\" has 20001 bytes; it can have up to 20000.");
        row("does not compile",
            "\"method\": \"listing\",\n\"code\": \"void frame()\\n{\\n feet[0].velocty = 1;\\n}\"",
            "line 6: \"code\" does not compile. Line 3: 'velocty' is not a member of Body. Did you mean "
            "'velocity'?");
        row("empty", "\"method\": \"listing\",\n\"code\": \"\"",
            "line 6: \"code\" does not compile. Line 1: The function 'void frame()' is missing. It runs once "
            "in every "
            "frame.");
        row("a draft that is a list", "\"draft\": []",
            "line 5: \"draft\" is a list; it must be a text in double quotes.");
        row("a draft that is too long", "\"draft\": \"" + QByteArray(20'001, 'x') + "\"",
            "line 5: \"draft\" has 20001 bytes; it can have up to 20000.");
        row("half steps", "\"method\": \"listing\",\n\"h\": 0.5,\n\"code\": \"void frame() {}\"",
            "line 1: Your code computes whole frames, so its step cannot be 0.5. Choose a step of 1 frame.");
        row("a tolerance", "\"method\": \"listing\",\n\"tolerance\": 1e-6,\n\"code\": \"void frame() {}\"",
            "line 6: the method \"listing\" has fixed steps; give \"h\" instead of \"tolerance\".");
    }
    void aWrongListingFileIsRefusedWithTheLine() { user_errors::checkRow(); }

    void mutatedFilesAreReadOrRefused()
    {
        Opened opened("multi_foot", "any_number");
        opened.session.code().write(Opened::with(opened.listing(), "*= damp", "*= 0.5"));
        opened.session.code().write(opened.session.code().text() + "}");
        const QByteArray text = experimentText(opened.session.experiment(), library());
        unsigned random = 12345;
        const auto next = [&](qsizetype below) {
            random = random * 1664525u + 1013904223u;
            return static_cast<qsizetype>((random >> 8) % static_cast<unsigned>(below));
        };
        int read = 0;
        for (int i = 0; i < 300; ++i) {
            QByteArray mutated = text;
            for (qsizetype j = next(3); j >= 0; --j)
                mutated[next(mutated.size())] = char(32 + next(95));
            try {
                parseExperiment(mutated, "x.json", library());
                ++read;
            } catch (const UserError &error) {
                QVERIFY(!error.sentence().isEmpty());
            }
        }
        QVERIFY(read > 0 && read < 300);
    }

    void codeTracesThePublishedTrajectory_data()
    {
        QTest::addColumn<QString>("path");
        for (const QFileInfo &info : QDir(TEST_DATA "/published").entryInfoList({"*.json"})) {
            const QJsonObject object =
                QJsonDocument::fromJson(tests::contentsOf(info.absoluteFilePath())).object();
            const LessonEntry *lesson = library().lesson(object["lesson"].toString());
            const lessons::Step *step = lesson ? lesson->step(object["step"].toString()) : nullptr;
            const bool isPlain = step && !step->listing.isEmpty() && step->method == "published" &&
                                 object["method"].toString(step->method) == step->method &&
                                 object["h"].toDouble(1.0) == 1.0;
            if (isPlain)
                QTest::newRow(qPrintable(info.completeBaseName())) << info.absoluteFilePath();
        }
    }
    void codeTracesThePublishedTrajectory()
    {
        QFETCH(QString, path);
        QJsonObject object = QJsonDocument::fromJson(tests::contentsOf(path)).object();
        const lessons::Step &step =
            *library().lesson(object["lesson"].toString())->step(object["step"].toString());
        object["method"] = "listing";
        object["code"] = step.listing.text;
        QTemporaryDir folder;
        const QString file = folder.filePath("code.json");
        tests::writeFile(file, QJsonDocument(object).toJson());
        const program::Answer answer = program::springstep({"trace", file});
        QCOMPARE(answer.err, QString());
        QCOMPARE(answer.code, 0);
        program::compareTrajectories(answer.out, tests::contentsOf(path.chopped(5) + ".csv"));
    }

    void traceSaysWhichLineStoppedIt()
    {
        QTemporaryDir folder;
        const QString code =
            "void frame()\n{\n    int zero = 0;\n    int one = frame_number > 4 ? 1 / zero : 0;\n}\n";
        const QString path = program::fileWith(folder.path(), "\"method\": \"listing\",\n\"code\": " +
                                                                  QString::fromUtf8(inQuotes(code)));
        const program::Answer answer = program::springstep({"trace", path});
        QCOMPARE(answer.code, 1);
        QVERIFY2(answer.err.contains("Stopped at frame 4. Line 4 of your code: This divides by 0."),
                 qPrintable(answer.err));
    }

    void aDraftMakesTheDocumentChangedAndIsRecovered()
    {
        QTemporaryDir folder;
        QString left;
        {
            Opened opened("single_spring", "radial");
            Document document(opened.session);
            Autosave autosave(opened.session.run(), opened.session.comparisons(), document, folder.path());
            QVERIFY(!document.isChanged());
            left = opened.listing() + "void half";
            opened.session.code().write(left);
            QVERIFY(document.isChanged());
            opened.session.openStep("single_spring", "drag");
            QVERIFY(document.isChanged({"single_spring", "radial"}));
            autosave.saveNow();
        }
        const std::vector<RecoveredScene> scenes = recoveredScenes(folder.path());
        QCOMPARE(scenes.size(), std::size_t(1));
        Opened opened("single_spring", "drag");
        Document document(opened.session);
        document.open(readExperiment(scenes.front().file, library()));
        QCOMPARE(opened.session.code().text(), left);
        QVERIFY(document.isChanged());
        const QString path = folder.filePath("saved.json");
        document.save(path);
        QVERIFY(!document.isChanged());
    }
};

SUITE(tst_listing_file, ListingFileTest)
#include "tst_listing_file.moc"
