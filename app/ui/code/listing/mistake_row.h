#pragma once

#include "app/model/listing/code_text.h"

#include <QWidget>

class QLabel;

namespace app {

/// A row below a code editor that shows the first mistake. It is hidden while the code has no mistake.
class MistakeRow : public QWidget
{
    Q_OBJECT

public:
    explicit MistakeRow(QWidget *parent = nullptr);

    /// Returns the sentence; empty if nothing is wrong.
    QString sentence() const;
    /// Shows a sentence, or hides the row if it is empty.
    void setSentence(const QString &sentence);

private:
    QLabel *m_sentence;
};

/// Returns the first of `mistakes` with its line: "Line 3: There is no “velocty”."
QString mistakeSentence(const std::vector<CodeMistake> &mistakes);

}
