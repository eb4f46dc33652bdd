#pragma once

#include "app/model/glossary.h"
#include "app/ui/theme/theme.h"

#include <QDialog>

class QLineEdit;
class QTextBrowser;

namespace app {

/// All words of the lessons, with a search, and with a link to the step that teaches each.
class GlossaryPage : public QDialog
{
    Q_OBJECT

public:
    /// `glossary` must outlive this.
    GlossaryPage(const Glossary &glossary, const Theme &theme, QWidget *parent = nullptr);

    /// Shows the page with what is found for `typed`; with all words, if that is empty.
    void search(const QString &typed);

signals:
    void stepAsked(const QString &lesson, const QString &step);

private:
    void refresh();

    const Glossary &m_glossary;
    const Theme &m_theme;
    QLineEdit *m_search;
    QTextBrowser *m_list;
};

}
