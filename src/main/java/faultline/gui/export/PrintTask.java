package faultline.gui.export;

import faultline.paint.export.PrintablePage;
import faultline.paint.export.RenderRequest;
import java.awt.print.PrinterAbortException;
import java.awt.print.PrinterException;
import java.awt.print.PrinterJob;
import java.util.concurrent.ExecutionException;
import java.util.function.Consumer;
import javax.swing.SwingWorker;

/** Sends a picture to the printer that the user chooses. */
final class PrintTask extends SwingWorker<Void, Void> {

    private final PrinterJob job;
    private final Consumer<Throwable> onFailed;

    private PrintTask(PrinterJob job, Consumer<Throwable> failed) {
        this.job = job;
        this.onFailed = failed;
    }

    static void showDialogAndPrint(RenderRequest shot, String name, Consumer<Throwable> failed) {
        PrinterJob job = PrinterJob.getPrinterJob();
        job.setJobName(name);
        job.setPrintable(new PrintablePage(shot));
        if (job.printDialog()) {
            new PrintTask(job, failed).execute();
        }
    }

    @Override
    protected Void doInBackground() throws PrinterException {
        job.print();
        return null;
    }

    @Override
    protected void done() {
        try {
            get();
        } catch (ExecutionException broken) {
            // A user who cancels a print that has begun knows of it.
            if (!(broken.getCause() instanceof PrinterAbortException)) {
                onFailed.accept(broken.getCause());
            }
        } catch (InterruptedException broken) {
            Thread.currentThread().interrupt();
        }
    }
}
