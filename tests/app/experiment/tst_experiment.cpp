#include "tests/app/experiment/user_errors.h"

#include "app/model/text/quoting.h"
#include "sim/methods/methods.h"
#include "tests/suite.h"

using namespace user_errors;

namespace {

/// The ids of all methods, as messages list them.
QString methods()
{
    QStringList ids;
    for (const sim::MethodPtr &method : sim::allMethods())
        ids.push_back(QString::fromStdString(method->id()));
    ids.push_back("listing");
    return app::quotedList(ids);
}

/// The ids of all lessons, as messages list them.
QString lessonIds()
{
    QStringList ids;
    for (const app::LessonEntry &lesson : allLessons().lessons)
        ids.push_back(lesson.id);
    ids.push_back("sandbox");
    return app::quotedList(ids);
}

const QString ownLesson = QStringLiteral(" If it is a lesson without C++, open it in the window, or name its "
                                         "folder in SPRINGSTEP_LESSONS.");

}

/// Every mistake in an experiment file gets one sentence with the line and the remedy.
class TestExperiment : public QObject
{
    Q_OBJECT

private slots:
    void textThatIsNoExperimentIsRefused_data()
    {
        addColumns();
        const auto row = [](const char *name, const QByteArray &text, const QString &sentence) {
            QTest::newRow(name) << text << sentence;
        };
        row("empty", "", "line 1: the file is empty; it must begin with {.");
        row("blank", " \n\n ", "line 1: the file is empty; it must begin with {.");
        row("only a byte order mark", "\xEF\xBB\xBF", "line 1: the file is empty; it must begin with {.");
        row("prose", "Dear learner,\nhello",
            "line 1: this is not JSON; a value is a number, a \"text\", true, false, null, a [list] or an "
            "{object}.");
        row("zero bytes", QByteArray("{\n\0\0", 4),
            "line 2: there is a zero byte; an experiment is JSON text in UTF-8.");
        row("binary", "\x89PNG\r\n\x1a\n",
            "line 1: this is not JSON; a value is a number, a \"text\", true, false, null, a [list] or an "
            "{object}.");
        row("UTF-16", QByteArray("\xFF\xFE{\0}\0", 6),
            "line 1: there is a zero byte; an experiment is JSON text in UTF-8.");
        row("bytes that are not UTF-8", with("\"method\": \"\xC3(\""),
            "line 5: a text has bytes that are not UTF-8; save the file as UTF-8.");
        row("truncated after a name", with("\"h\"").chopped(3),
            "line 5: the file ends here too early; the rest of it is missing.");
        row("truncated in a text", "{\n\"format\": \"spri",
            "line 2: the file ends here too early; the rest of it is missing.");
        row("truncated in a number", "{\n\"h\": 1.",
            "line 2: the file ends here too early; the rest of it is missing.");
        row("truncated in a word", "{\n\"h\": tru",
            "line 2: the file ends here too early; the rest of it is missing.");
        row("a list", "[1, 2]", "line 1: the file is a list; it must be an object in { }.");
        row("a number", "12", "line 1: the file is 12; it must be an object in { }.");
        row("two experiments", "{}\n{}",
            "line 2: there is text after the end; remove everything after the closing bracket.");
        row("a missing comma", with("\"h\": 1\n\"frames\": 2"),
            "line 6: a comma or a closing } is expected here.");
        row("a comma too many", with("\"h\": 1,"),
            "line 6: nothing follows the last comma before this }; remove the comma.");
        row("a comma too many in a list", with("\"effects\": [\"walls\",]"),
            "line 5: nothing follows the last comma before this ]; remove the comma.");
        row("a zip", "PK\x03\x04 and more",
            "this is a zip. The window opens a zipped lesson if its name ends in .springstep-lesson.");
        row("a missing colon", with("\"h\" 1"),
            "line 5: a colon is expected here, between a name and its value.");
        row("a name without quotes", with("h: 1"), "line 5: a name in double quotes is expected here.");
        row("a list that does not end", with("\"input\": [ {} }"),
            "line 5: a comma or a closing ] is expected here.");
        row("a comment", with("// h\n\"h\": 1"), "line 5: a name in double quotes is expected here.");
        row("a line break in a text", with("\"method\": \"publ\nished\""),
            "line 5: a text in double quotes is not valid; it must end on its own line, and only \" \\ / b f "
            "n r t u may follow a \\.");
        row("a wrong escape", with("\"method\": \"\\x\""),
            "line 5: a text in double quotes is not valid; it must end on its own line, and only \" \\ / b f "
            "n r t u may follow a \\.");
        row("half a surrogate", with("\"method\": \"\\ud800\""),
            "line 5: a text in double quotes is not valid; it must end on its own line, and only \" \\ / b f "
            "n r t u may follow a \\.");
        row("NaN", with("\"h\": NaN"),
            "line 5: this is not JSON; a value is a number, a \"text\", true, false, null, a [list] or an "
            "{object}.");
        row("Infinity", with("\"h\": -Infinity"),
            "line 5: this is not JSON; a value is a number, a \"text\", true, false, null, a [list] or an "
            "{object}.");
        row("1e999", with("\"h\": 1e999"), "line 5: a number is too large; the largest is 1.8e308.");
        row("1.8e308", with("\"h\": 1.8e308"),
            "line 5: \"h\" is 0; it can be 0.000001 to 100 frames, a whole number or 1 divided by one: 2, 1, "
            "0.5, 0.25...");
        row("-1e999", with("\"h\":\n-1e999"), "line 6: a number is too large; the largest is 1.8e308.");
        row("10^400 in digits", with("\"h\": 1" + QByteArray(400, '0')),
            "line 5: a number is too large; the largest is 1.8e308.");
        row("a number with a leading zero", with("\"h\": 01"),
            "line 5: a comma or a closing } is expected here.");
        row("a number that ends in a point", with("\"h\": 1."),
            "line 5: a number is not complete; write it as 0.5 or 5e-1.");
        row("hexadecimal", with("\"h\": 0x10"), "line 5: a comma or a closing } is expected here.");
        row("a name twice", with("\"h\": 1,\n\"h\": 2"), "line 6: \"h\" is given twice; keep one of them.");
        row("a body twice",
            with("\"bodies\": {\"body\": {\"x\": 1, \"y\": 2},\n\"body\": {\"x\": 1, \"y\": 2}}"),
            "line 6: \"body\" is given twice; keep one of them.");
        row("17 lists in each other", with("\"input\": " + QByteArray(17, '[')),
            "line 5: lists and objects are nested more than 16 deep here; an experiment needs only 3 "
            "levels.");
        row("a million lists in each other", QByteArray(1'000'000, '['),
            "line 1: lists and objects are nested more than 16 deep here; an experiment needs only 3 "
            "levels.");
        row("a million objects in each other", QByteArray("{\"a\":").repeated(1'000'000),
            "line 1: lists and objects are nested more than 16 deep here; an experiment needs only 3 "
            "levels.");
    }
    void textThatIsNoExperimentIsRefused() { checkRow(); }

    void missingRequiredFieldsAreNamed_data()
    {
        addColumns();
        const auto row = [](const char *name, const QByteArray &text, const QString &sentence) {
            QTest::newRow(name) << text << sentence;
        };
        const QByteArray format = "\"format\": \"springstep-experiment/1\"";
        const QString lessons = lessonIds();
        row("nothing in it", "{}",
            "line 1: the file has no \"format\"; add it. It must be \"springstep-experiment/1\".");
        row("another format", "{\"format\": \"drawing\"}",
            "line 1: \"format\" is \"drawing\"; this program reads \"springstep-experiment/1\".");
        row("a later format", "{\"format\": \"springstep-experiment/2\"}",
            "line 1: \"format\" is \"springstep-experiment/2\"; this program reads "
            "\"springstep-experiment/1\".");
        row("a format that is a number", "{\"format\": 1}",
            "line 1: \"format\" is 1; it must be a text in double quotes.");
        row("no lesson", "{" + format + "}",
            "line 1: the file has no \"lesson\"; add it. It must be " + lessons + ".");
        row("a lesson that is a list", "{" + format + ", \"lesson\": []}",
            "line 1: \"lesson\" is a list; it must be a text in double quotes.");
        row("no step", "{" + format + ", \"lesson\": \"two_body\"}",
            "line 1: the file has no \"step\"; add it. It must be \"mutual\", \"leg_line\".");
        row("an unknown lesson", "{" + format + ",\n\"lesson\": \"three_body\", \"step\": \"mutual\"}",
            "line 2: there is no lesson \"three_body\"; there is " + lessons + "." + ownLesson);
        row("an unknown step", "{" + format + ",\n\"lesson\": \"two_body\",\n\"step\": \"mutal\"}",
            "line 3: the lesson \"two_body\" has no step \"mutal\"; it has \"mutual\", \"leg_line\".");
        row("a lesson with a line break and an escape sequence",
            "{" + format + ", \"lesson\": \"a\\nb\\u001b[31m\", \"step\": \"mutual\"}",
            "line 1: there is no lesson \"a\\nb\\u001b[31m\"; there is " + lessons + "." + ownLesson);
        row("a lesson of a million letters",
            "{" + format + ", \"lesson\": \"" + QByteArray(1'000'000, 'a') + "\", \"step\": \"mutual\"}",
            "line 1: there is no lesson \"aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa\u2026\"; there is " +
                lessons + "." + ownLesson);
        row("an unknown field", with("\"gravity\": 1"),
            "line 5: the file has no field \"gravity\"; there is \"format\", \"lesson\", \"step\", "
            "\"method\", \"code\", \"h\", \"tolerance\", \"effects\", \"scene\", \"frames\", "
            "\"parameters\", \"bodies\", \"links\", \"seed\", \"input\", \"draft\", \"name\", \"named\", "
            "\"kept\", \"branches\".");
    }
    void missingRequiredFieldsAreNamed() { checkRow(); }

    void aFieldOutOfItsRangeIsRefused_data()
    {
        addColumns();
        const auto row = [](const char *name, const QByteArray &fields, const QString &sentence) {
            QTest::newRow(name) << with(fields) << sentence;
        };
        row("an unknown method", "\"method\": \"rk5\"",
            "line 5: there is no method \"rk5\"; there is " + methods() + ".");
        row("a method that is true", "\"method\": true",
            "line 5: \"method\" is true; it must be a text in double quotes.");
        row("h of 0", "\"h\": 0",
            "line 5: \"h\" is 0; it can be 0.000001 to 100 frames, a whole number or 1 divided by one: 2, 1, "
            "0.5, 0.25...");
        row("h below 0", "\"h\": -1",
            "line 5: \"h\" is -1; it can be 0.000001 to 100 frames, a whole number or 1 divided by one: 2, "
            "1, 0.5, 0.25...");
        row("h of 0.3", "\"h\": 0.3",
            "line 5: \"h\" is 0.3; it can be 0.000001 to 100 frames, a whole number or 1 divided by one: 2, "
            "1, 0.5, 0.25...");
        row("h of 1.5", "\"h\": 1.5",
            "line 5: \"h\" is 1.5; it can be 0.000001 to 100 frames, a whole number or 1 divided by one: 2, "
            "1, 0.5, 0.25...");
        row("h of 101", "\"h\": 101",
            "line 5: \"h\" is 101; it can be 0.000001 to 100 frames, a whole number or 1 divided by one: 2, "
            "1, 0.5, 0.25...");
        row("h of 1e-7", "\"h\": 1e-7",
            "line 5: \"h\" is 1e-7; it can be 0.000001 to 100 frames, a whole number or 1 divided by one: "
            "2, 1, 0.5, 0.25...");
        row("h as text", "\"h\": \"1\"", "line 5: \"h\" is the text \"1\"; it must be a number.");
        row("tolerance", "\"tolerance\": 0.001",
            "line 5: the method \"published\" has fixed steps; give \"h\" instead of \"tolerance\".");
        row("h for a method that chooses its steps", "\"method\": \"dormand_prince\",\n\"h\": 0.5",
            "line 6: the method \"dormand_prince\" chooses its own steps; give \"tolerance\" instead of "
            "\"h\".");
        row("h beside a tolerance", "\"method\": \"dormand_prince\", \"tolerance\": 1,\n\"h\": 0.5",
            "line 6: the method \"dormand_prince\" chooses its own steps; give \"tolerance\" instead of "
            "\"h\".");
        row("a tolerance of 0", "\"method\": \"dormand_prince\", \"tolerance\": 0",
            "line 5: \"tolerance\" is 0; it can be 1e-13 to 100 px.");
        row("a tolerance of 101", "\"method\": \"dormand_prince\", \"tolerance\": 101",
            "line 5: \"tolerance\" is 101; it can be 1e-13 to 100 px.");
        row("a tolerance as text", "\"method\": \"dormand_prince\", \"tolerance\": \"1\"",
            "line 5: \"tolerance\" is the text \"1\"; it must be a number.");
        row("an unknown effect", "\"effects\": [\n\"gravity\"]",
            "line 6: the step \"any_number\" has no effect \"gravity\"; it has \"damping\", "
            "\"radial_spring\".");
        row("an effect that is a number", "\"effects\": [7]",
            "line 5: \"effects\" is 7; it must be a text in double quotes.");
        row("effects as text", "\"effects\": \"springs\"",
            "line 5: \"effects\" is the text \"springs\"; it must be a list in [ ].");
        row("a scene", "\"scene\": {}",
            "line 5: \"scene\" does not go with a lesson's step, which has its own; remove it, and change "
            "that one by \"parameters\", \"bodies\" and \"effects\".");
        row("links", "\"links\": [{\"a\": \"p0\"}]",
            "line 5: the step \"any_number\" has no sticks; remove \"links\".");
        row("links as text", "\"links\": \"none\"",
            "line 5: \"links\" is the text \"none\"; it must be a list in [ ].");
        row("frames below 0", "\"frames\": -1",
            "line 5: \"frames\" is -1; it can be a whole number from 0 to 10000000.");
        row("half a frame", "\"frames\": 0.5",
            "line 5: \"frames\" is 0.5; it can be a whole number from 0 to 10000000.");
        row("10 million and 1 frames", "\"frames\": 10000001",
            "line 5: \"frames\" is 10000001; it can be a whole number from 0 to 10000000.");
        row("frames of 1e300", "\"frames\": 1e300",
            "line 5: \"frames\" is 1e300; it can be a whole number from 0 to 10000000.");
        row("frames as null", "\"frames\": null", "line 5: \"frames\" is null; it must be a number.");
        row("a seed below 0", "\"seed\": -1",
            "line 5: \"seed\" is -1; it can be a whole number from 0 to 9007199254740992.");
        row("a seed that is not whole", "\"seed\": 1.5",
            "line 5: \"seed\" is 1.5; it can be a whole number from 0 to 9007199254740992.");
        row("a seed of 2^53 + 1", "\"seed\": 9007199254740993",
            "line 5: \"seed\" is beyond 2^53; it can be a whole number from 0 to 9007199254740992.");
        row("a seed of 2^64", "\"seed\": 18446744073709551616",
            "line 5: \"seed\" is 18446744073709552000; it can be a whole number from 0 to 9007199254740992.");
        row("a billion feet", "\"parameters\": {\n\"feet\": 1000000000}",
            "line 6: \"feet\" is 1000000000; it can be a whole number from 1 to 100.");
        row("no feet", "\"parameters\": {\"feet\": 0}",
            "line 5: \"feet\" is 0; it can be a whole number from 1 to 100.");
        row("two and a half feet", "\"parameters\": {\"feet\": 2.5}",
            "line 5: \"feet\" is 2.5; it can be a whole number from 1 to 100.");
        row("a factor above its range", "\"parameters\": {\"k\": 0.1,\n\"damp\": 1.4}",
            "line 6: \"damp\" is 1.4; it can be 0 to 1.");
        row("a factor below its range", "\"parameters\": {\"damp\": -0.1}",
            "line 5: \"damp\" is -0.1; it can be 0 to 1.");
        row("an unknown parameter", "\"parameters\": {\"gravity\": 1}",
            "line 5: the step \"any_number\" has no parameter \"gravity\"; it has \"k\", \"damp\", "
            "\"radius\", \"feet\".");
        row("a parameter as text", "\"parameters\": {\"k\": \"0.2\"}",
            "line 5: \"k\" is the text \"0.2\"; it must be a number.");
        row("parameters as a list", "\"parameters\": [0.2]",
            "line 5: \"parameters\" is a list; it must be an object in { }.");
        row("an unknown body", "\"bodies\": {\n\"foot9\": {\"x\": 1, \"y\": 2}}",
            "line 6: there is no body \"foot9\" here; there is \"foot0\", \"foot1\", \"foot2\", \"foot3\", "
            "\"foot4\", \"body\".");
        row("a body for one foot more",
            "\"parameters\": {\"feet\": 2},\n\"bodies\": {\"foot2\": {\"x\": 1, \"y\": 2}}",
            "line 6: there is no body \"foot2\" here; there is \"foot0\", \"foot1\", \"body\".");
        row("a body without y", "\"bodies\": {\"body\": {\"x\": 1}}",
            "line 5: the body \"body\" has no \"y\"; add it. It must be a number.");
        row("a body as text", "\"bodies\": {\"body\": \"here\"}",
            "line 5: the body \"body\" is the text \"here\"; it must be an object in { }.");
        row("a body with a mass", "\"bodies\": {\"body\": {\"x\": 1, \"y\": 2, \"mass\": 3}}",
            "line 5: the body \"body\" has no field \"mass\"; there is \"x\", \"y\", \"vx\", \"vy\".");
        row("a body's speed as null", "\"bodies\": {\"body\": {\"x\": 1, \"y\": 2, \"vx\": null}}",
            "line 5: \"vx\" is null; it must be a number.");
        row("bodies as a list", "\"bodies\": []",
            "line 5: \"bodies\" is a list; it must be an object in { }.");
    }
    void aFieldOutOfItsRangeIsRefused() { checkRow(); }

    void aTreeThatGrowsTooBigIsRefused_data()
    {
        addColumns();
        const auto row = [](const char *name, const QByteArray &fields, const QString &sentence) {
            QTest::newRow(name)
                << "{\n\"format\": \"springstep-experiment/1\",\n\"lesson\": \"swaying_tree\",\n"
                   "\"step\": \"turbulence\",\n" +
                       fields + "\n}\n"
                << sentence;
        };
        const QString tooBig =
            "This tree would have more than 131071 branches: make its slope smaller than %1, or "
            "its smallest branch larger than %2.";
        row("branches that are all alike", "\"parameters\": {\"slope\": 1}",
            "line 1: " + tooBig.arg("1").arg("0.2"));
        row("no smallest branch", "\"parameters\": {\"min_scale\": 0}",
            "line 1: " + tooBig.arg("0.8").arg("0"));
        row("with a body of its own",
            "\"parameters\": {\"slope\": 1},\n\"bodies\": {\"branch7\": {\"x\": 1, \"y\": 2}}",
            "line 1: " + tooBig.arg("1").arg("0.2"));
        row("later",
            "\"input\": [\n{\"frame\": 3, \"event\": \"set\", \"parameter\": \"slope\", \"value\": 2}]",
            "line 6: " + tooBig.arg("2").arg("0.2"));
    }
    void aTreeThatGrowsTooBigIsRefused() { checkRow(); }

    void moreValuesThanAnExperimentHasAreRefused()
    {
        const QByteArray text = with("\"input\": [" + QByteArray("1,").repeated(3 << 20) + "1]");
        QCOMPARE(errorOf(text),
                 "x.json: line 5: here begins one value too many; an experiment has at most 2097152 values.");
    }
};

SUITE(tst_experiment, TestExperiment)
#include "tst_experiment.moc"
