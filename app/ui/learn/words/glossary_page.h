#pragma once

#include "app/model/text/glossary.h"
#include "app/ui/theme/theme.h"

#include <QDialog>

class QLineEdit;
class QTextBrowser;

namespace app {

/// A page with all words of the lessons, a search field, and a link from each word to the step that teaches
/// it.
class GlossaryPage : public QDialog
{
    Q_OBJECT

public:
    /// `glossary` must outlive this.
    GlossaryPage(const Glossary &glossary, const Theme &theme, QWidget *parent = nullptr);

    /// Shows the page with the words that match `typed`, or with all words if `typed` is empty.
    void search(const QString &typed);
    /// Shows the words that the glossary has now.
    void refresh();

signals:
    void stepRequested(const QString &lesson, const QString &step);

private:
    const Glossary &m_glossary;
    const Theme &m_theme;
    QLineEdit *m_search;
    QTextBrowser *m_list;
};

}
