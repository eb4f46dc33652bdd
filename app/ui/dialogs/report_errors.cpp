#include "app/ui/dialogs/report_errors.h"

#include "app/model/text/sentences.h"
#include "app/model/text/user_error.h"
#include "app/ui/dialogs/notice.h"
#include "sim/base/error.h"

#include <QCoreApplication>

#include <new>

namespace app {

bool attempt(Notice &notice, const QString &failure, const std::function<void()> &action)
{
    QString why;
    try {
        action();
        return true;
    } catch (const UserError &error) {
        why = error.sentence();
    } catch (const sim::Error &error) {
        why = sentenceFor(error);
    } catch (const std::bad_alloc &) {
        why = QCoreApplication::translate("Attempt", "There is not enough memory.");
    }
    notice.showMessage(failure.arg(why));
    return false;
}

}
