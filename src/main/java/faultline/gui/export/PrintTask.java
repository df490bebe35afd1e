package faultline.gui.export;

import faultline.gui.document.BackgroundTasks;
import faultline.paint.export.PrintablePage;
import faultline.paint.export.RenderRequest;
import java.awt.print.PrinterAbortException;
import java.awt.print.PrinterJob;
import java.util.function.Consumer;

/** Prints an image in the background. */
final class PrintTask {

    private PrintTask() {}

    /** Asks for a printer and prints, unless the user cancels. */
    static void showDialogAndPrint(RenderRequest request, String jobName, Consumer<Throwable> onFailed) {
        PrinterJob job = PrinterJob.getPrinterJob();
        job.setJobName(jobName);
        job.setPrintable(new PrintablePage(request));
        if (job.printDialog()) {
            BackgroundTasks.run(
                    () -> {
                        job.print();
                        return job;
                    },
                    done -> {},
                    failure -> {
                        // An abort is the user's own doing.
                        if (!(failure instanceof PrinterAbortException)) {
                            onFailed.accept(failure);
                        }
                    });
        }
    }
}
