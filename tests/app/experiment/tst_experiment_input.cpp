#include "tests/app/experiment/user_errors.h"
#include "tests/suite.h"

using namespace user_errors;

/// Events that a run cannot follow are refused; what is unusual but possible is accepted.
class TestExperimentInput : public QObject
{
    Q_OBJECT

private slots:
    void impossibleEventIsRefused_data()
    {
        addColumns();
        const auto row = [](const char *name, const QByteArray &events, const QString &sentence) {
            QTest::newRow(name) << with("\"input\": [\n" + events + "]") << sentence;
        };
        const QByteArray grab = "{\"frame\": 1, \"event\": \"grab\", \"body\": \"body\"}";
        const QByteArray release = "{\"frame\": 2, \"event\": \"release\"}";
        row("no object", "7", "line 6: an event is 7; it must be an object in { }.");
        row("no event", "{\"frame\": 1}",
            "line 6: an event has no \"event\"; add it. It must be \"grab\", \"move\", \"release\", "
            "\"set\".");
        row("an unknown event", "{\"frame\": 1, \"event\": \"throw\"}",
            "line 6: the step \"any_number\" has no event \"throw\"; it has \"grab\", \"move\", \"release\", "
            "\"set\".");
        row("an event of other lessons", "{\"frame\": 1, \"event\": \"pointer\", \"x\": 1, \"y\": 2}",
            "line 6: the step \"any_number\" has no event \"pointer\"; it has \"grab\", \"move\", "
            "\"release\", \"set\".");
        row("an event that is a number", "{\"frame\": 1, \"event\": 1}",
            "line 6: \"event\" is 1; it must be a text in double quotes.");
        row("no frame", "{\"event\": \"release\"}",
            "line 6: an event has no \"frame\"; add it. It must be a whole number.");
        row("a frame below 0", "{\"frame\": -1, \"event\": \"release\"}",
            "line 6: \"frame\" is -1; it can be a whole number from 0 to 10000000.");
        row("half a frame", "{\"frame\": 0.5, \"event\": \"release\"}",
            "line 6: \"frame\" is 0.5; it can be a whole number from 0 to 10000000.");
        row("a frame past 10 million", "{\"frame\": 10000001, \"event\": \"release\"}",
            "line 6: \"frame\" is 10000001; it can be a whole number from 0 to 10000000.");
        row("a grab of nothing", "{\"frame\": 1, \"event\": \"grab\"}",
            "line 6: an event has no \"body\"; add it. It must be a body's name.");
        row("a grab of a number", "{\"frame\": 1, \"event\": \"grab\", \"body\": 1}",
            "line 6: \"body\" is 1; it must be a text in double quotes.");
        row("a grab of an unknown body", "{\"frame\": 1, \"event\": \"grab\", \"body\": \"head\"}",
            "line 6: there is no body \"head\" here; there is \"foot0\", \"foot1\", \"foot2\", \"foot3\", "
            "\"foot4\", \"body\".");
        row("a grab with a place", "{\"frame\": 1, \"event\": \"grab\", \"body\": \"body\", \"x\": 1}",
            "line 6: an event has no field \"x\"; there is \"frame\", \"event\", \"body\".");
        row("a move without y", grab + ",\n{\"frame\": 1, \"event\": \"move\", \"x\": 1}",
            "line 7: an event has no \"y\"; add it. It must be a number.");
        row("a move before any grab", "{\"frame\": 1, \"event\": \"move\", \"x\": 1, \"y\": 1}",
            "line 6: nothing is held at frame 1; a \"move\" comes after a \"grab\".");
        row("a move that a later line grabs for",
            "{\"frame\": 1, \"event\": \"move\", \"x\": 1, \"y\": 1},\n" + grab,
            "line 6: nothing is held at frame 1; a \"move\" comes after a \"grab\".");
        row("a release before any grab", release,
            "line 6: nothing is held at frame 2; a \"release\" comes after a \"grab\".");
        row("a second release", grab + ",\n" + release + ",\n" + release,
            "line 8: nothing is held at frame 2; a \"release\" comes after a \"grab\".");
        row("a grab out of order", release + ",\n" + grab + ",\n{\"frame\": 0, \"event\": \"release\"}",
            "line 8: nothing is held at frame 0; a \"release\" comes after a \"grab\".");
        row("set without a value", "{\"frame\": 1, \"event\": \"set\", \"parameter\": \"k\"}",
            "line 6: an event has no \"value\"; add it. It must be a value of that parameter.");
        row("set of an unknown parameter",
            "{\"frame\": 1, \"event\": \"set\", \"parameter\": \"kk\", \"value\": 1}",
            "line 6: the step \"any_number\" has no parameter \"kk\"; it has \"k\", \"damp\", \"radius\", "
            "\"feet\".");
        row("set out of the range",
            "{\"frame\": 1, \"event\": \"set\", \"parameter\": \"feet\", \"value\": 101}",
            "line 6: \"feet\" is 101; it can be a whole number from 1 to 100.");
        row("a grab of a foot that set has removed",
            "{\"frame\": 1, \"event\": \"set\", \"parameter\": \"feet\", \"value\": 3},\n"
            "{\"frame\": 2, \"event\": \"grab\", \"body\": \"foot4\"}",
            "line 7: there is no body \"foot4\" here; there is \"foot0\", \"foot1\", \"foot2\", \"body\".");
        row("a grab of a foot that set brings later",
            "{\"frame\": 1, \"event\": \"grab\", \"body\": \"foot7\"},\n"
            "{\"frame\": 2, \"event\": \"set\", \"parameter\": \"feet\", \"value\": 8}",
            "line 6: there is no body \"foot7\" here; there is \"foot0\", \"foot1\", \"foot2\", \"foot3\", "
            "\"foot4\", \"body\".");
    }
    void impossibleEventIsRefused() { checkRow(); }

    void possibleInputIsAccepted_data()
    {
        QTest::addColumn<QByteArray>("text");
        const auto row = [](const char *name, const QByteArray &text) { QTest::newRow(name) << text; };
        row("a byte order mark", "\xEF\xBB\xBF" + with("\"h\": 1"));
        row("Windows line ends", with("\"h\": 1").replace("\n", "\r\n"));
        row("a name as escapes", with("\"\\u0068\": 1"));
        row("no links", with("\"links\": []"));
        row("h of 0.000001", with("\"h\": 0.000001"));
        row("h of 1/3", with("\"h\": 0.33333333333333331"));
        row("h of 100", with("\"h\": 1e2"));
        row("10 million frames", with("\"frames\": 10000000"));
        row("no frame", with("\"frames\": 0"));
        row("a seed of 2^53", with("\"seed\": 9007199254740992"));
        row("the least number", with("\"bodies\": {\"body\": {\"x\": 5e-324, \"y\": -1e-400}}"));
        row("the largest number", with("\"bodies\": {\"body\": {\"x\": 1.7976931348623157e308, \"y\": -0}}"));
        row("half of a speed", with("\"bodies\": {\"body\": {\"x\": 1, \"y\": 2, \"vy\": 3}}"));
        row("100 feet",
            with("\"parameters\": {\"feet\": 1e2}, \"bodies\": {\"foot99\": {\"x\": 1, \"y\": 2}}"));
        row("a radius between whole numbers", with("\"parameters\": {\"radius\": 62.5}"));
        row("a second grab lets go of the first", with("\"input\": [{\"frame\": 1, \"event\": \"grab\", "
                                                       "\"body\": \"foot0\"}, {\"frame\": 1, \"event\": "
                                                       "\"grab\", \"body\": \"foot1\"}]"));
        row("events in any order of frames", with("\"input\": [{\"frame\": 2, \"event\": \"release\"}, "
                                                  "{\"frame\": 1, \"event\": \"grab\", \"body\": "
                                                  "\"foot0\"}]"));
        row("a grab of a foot that set brings in the same frame",
            with("\"input\": [{\"frame\": 1, \"event\": \"grab\", \"body\": \"foot7\"}, {\"frame\": 1, "
                 "\"event\": "
                 "\"set\", \"parameter\": \"feet\", \"value\": 8}]"));
    }
    void possibleInputIsAccepted()
    {
        QFETCH(QByteArray, text);
        QCOMPARE(errorOf(text), QString());
    }
};

SUITE(tst_experiment_input, TestExperimentInput)
#include "tst_experiment_input.moc"
