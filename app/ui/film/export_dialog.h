#pragma once

#include "app/model/files/export.h"

#include <QDialog>
#include <QTimer>

#include <functional>
#include <memory>

class QGridLayout;
class QLabel;
class QProgressBar;
class QPushButton;
class QVBoxLayout;

namespace app {

class FrameRange;

/// The texts of an ExportDialog.
struct ExportTexts
{
    QString title;
    QString first, last; ///< tooltips of the fields for the first and the last frame
    QString progress;    ///< the accessible name of the bar
    QString cancel;      ///< a tooltip
};

/// A dialog that asks for the frames and settings of an export, and makes it while the window stays usable.
class ExportDialog : public QDialog
{
    Q_OBJECT

public:
    ExportDialog(const ExportTexts &texts, QWidget *parent);
    ~ExportDialog() override;

    bool isMaking() const { return m_export != nullptr; }
    /// Returns the message at the bottom: the progress, or how the export ended.
    QString message() const;
    void done(int result) override;

protected:
    /// Returns the form, which has the rows of the two frames first.
    QGridLayout &form() const { return *m_form; }
    QVBoxLayout &column() const { return *m_column; }
    FrameRange &range() const { return *m_range; }
    /// Returns the button that makes the export, after complete().
    QPushButton &makeButton() const { return *m_make; }
    /// Adds the buttons, which Tab reaches after all settings, and makes the dialog as high as it needs.
    void complete();
    void setMessage(const QString &sentence);
    /// Clears the message, unless it is about the export that is being made.
    void clearMessage();
    /// Makes what `begin` returns, in the file `path`. If `begin` throws, shows why.
    void make(const QString &path, const std::function<std::unique_ptr<Export>()> &begin);
    /// Enables and names everything for the present state.
    virtual void showState();
    /// Returns the message for an export that is cancelled at `frame`.
    virtual QString cancelled(std::int64_t frame) const;

private:
    void goOn();
    void cancel();
    void end(const QString &sentence);

    QString m_cancelHelp;
    QVBoxLayout *m_column;
    QWidget *m_settings;
    QGridLayout *m_form;
    FrameRange *m_range;
    QProgressBar *m_bar; ///< keeps its room while it is hidden
    QLabel *m_message;
    QPushButton *m_make = nullptr;
    QPushButton *m_stop = nullptr;
    std::unique_ptr<Export> m_export;
    QString m_path; ///< of m_export
    QTimer m_next;  ///< for the next piece; active while an export is made
};

}
