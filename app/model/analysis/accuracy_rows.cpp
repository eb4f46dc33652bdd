#include "app/model/analysis/accuracy_rows.h"

#include "app/model/text/accuracy_text.h"
#include "app/model/text/csv.h"
#include "sim/pipeline/method.h"

#include <algorithm>
#include <limits>

namespace app {

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN(); ///< an empty field

void appendRow(QByteArray &text, const sim::AccuracyRow &row)
{
    const sim::StepSize &step = row.setup.step;
    const bool isTimed = row.nsPerFrame > 0.0;
    text += quotedField(QString::fromStdString(row.setup.method->id())) + ',' +
            QByteArray::number(row.setup.method->order());
    for (const double value :
         {step.isAdaptive() ? none : step.h, step.isAdaptive() ? step.tolerance : none, row.error,
          row.evaluations, isTimed ? row.nsPerFrame : none, isTimed ? row.spread : none})
        appendField(text, value);
    text += row.front ? ",1\n" : ",0\n";
}

}

QByteArray accuracyRows(const sim::Accuracy &accuracy)
{
    // The same column titles as in the command line.
    const QByteArray titles = "method,order,\"h [frames]\",\"tolerance [px]\",\"error [px]\",evaluations,"
                              "ns_per_frame,spread,front\n";
    QByteArray text;
    for (const sim::AccuracyRow &row : accuracy.rows) {
        if (row.outcome == sim::Outcome::measured)
            appendRow(text, row);
    }
    return text.isEmpty() ? text : titles + text;
}

QByteArray errorsOverRun(const sim::Accuracy &accuracy, const std::vector<std::size_t> &rows)
{
    if (rows.empty())
        return {};
    QByteArray text = "frame";
    std::size_t frames = 0;
    for (const std::size_t row : rows) {
        text += ',' + quotedField(QStringLiteral("%1 [px]").arg(setupTitle(accuracy.rows[row].setup)));
        frames = std::max(frames, accuracy.rows[row].errorAt.size());
    }
    text += '\n';
    for (std::size_t frame = 0; frame < frames; ++frame) {
        text += QByteArray::number(static_cast<qulonglong>(frame));
        for (const std::size_t row : rows) {
            const std::vector<double> &errors = accuracy.rows[row].errorAt;
            appendField(text, frame < errors.size() ? errors[frame] : none);
        }
        text += '\n';
    }
    return text;
}

}
