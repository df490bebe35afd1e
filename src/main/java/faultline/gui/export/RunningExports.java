package faultline.gui.export;

import faultline.gui.action.Notes;
import faultline.gui.dialog.Dialogs;
import faultline.gui.document.FileNames;
import faultline.gui.document.Leaving;
import faultline.gui.text.ErrorMessages;
import faultline.gui.text.Messages;
import java.awt.Component;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.function.Consumer;
import java.util.function.ToIntFunction;
import java.util.stream.Collectors;

/**
 * The exports that are being written, and the question whether the window waits for them before it closes. Used on the
 * event dispatch thread.
 */
public final class RunningExports {

    private final Component parent;
    private final Consumer<Path> onWritten;
    private final Consumer<String> errorDialog;
    private final Notes notes;
    private final List<ExportTask> tasks = new ArrayList<>();
    private ToIntFunction<String> exitQuestion = this::askToExit;
    /** What waits until all exports are complete, null for nothing. */
    private Runnable afterExports;
    /** The sentence that says what is waited for. */
    private String waitingNote = "";
    /** The number of exports that have failed or were cancelled. */
    private int failures;

    /**
     * Creates the exports of a window. {@code onWritten} is called with each file that has been written, and
     * {@code errorDialog} with the sentence of each failure.
     */
    RunningExports(Component parent, Consumer<Path> onWritten, Consumer<String> errorDialog, Notes notes) {
        this.parent = parent;
        this.onWritten = onWritten;
        this.errorDialog = errorDialog;
        this.notes = notes;
    }

    /** Sets what asks whether to exit, given a sentence: 0 to wait before that, 1 to cancel the exports. */
    void setExitQuestion(ToIntFunction<String> newQuestion) {
        exitQuestion = newQuestion;
    }

    /**
     * Starts to write a file. {@code then} runs when it is written, or {@code otherwise} when that has failed or was
     * cancelled.
     */
    void start(Path file, FileExport export, Runnable then, Runnable otherwise) {
        String writing = Messages.get("export.writing", FileNames.lastOf(file));
        notes.show(writing);
        ExportTask task = new ExportTask(
                parent,
                export,
                file,
                () -> {
                    tasks.removeIf(ExportTask::isDone);
                    notes.remove(writing);
                },
                written -> {
                    onWritten.accept(written);
                    then.run();
                    runAfterExports();
                },
                failure -> {
                    failures++;
                    stopWaiting();
                    otherwise.run();
                    if (!(failure instanceof CancellationException)) {
                        errorDialog.accept(failureText(file, failure));
                    }
                });
        tasks.add(task);
        task.start();
    }

    /**
     * Runs an action that closes the window, after asking whether to wait for the exports that are being written. The
     * action does not run if the user wants to stay, or waits for an export that fails or is cancelled.
     */
    public void runIfHandled(Leaving leaving, Runnable action) {
        stopWaiting();
        if (tasks.stream().allMatch(leaving::isDiscarded)) {
            action.run();
            return;
        }
        int before = failures;
        int answer = exitQuestion.applyAsInt(Messages.get("export.exit", names()));
        if (answer == 0 && !tasks.isEmpty()) {
            afterExports = action;
            waitingNote = Messages.get("export.exit.waiting", names());
            notes.keep(waitingNote);
        } else if (answer == 0 && failures == before || answer == 1) {
            tasks.forEach(leaving::discard);
            action.run();
        }
    }

    private String names() {
        return tasks.stream().map(ExportTask::name).collect(Collectors.joining(", "));
    }

    /** Cancels the exports that are being written, because the window closes. */
    public void cancel() {
        stopWaiting();
        tasks.forEach(ExportTask::cancel);
    }

    /** Returns the sentence that says why a file is not written. */
    static String failureText(Path file, Throwable failure) {
        return Messages.get("export.failed", file.toString(), ErrorMessages.describe(failure, file));
    }

    private void runAfterExports() {
        Runnable action = afterExports;
        if (tasks.isEmpty() && action != null) {
            stopWaiting();
            action.run();
        }
    }

    private void stopWaiting() {
        afterExports = null;
        notes.remove(waitingNote);
    }

    private int askToExit(String question) {
        return Dialogs.ask(
                parent,
                Messages.get("export.title"),
                question,
                "export.exit.wait",
                "export.exit.cancel",
                "export.exit.stay");
    }
}
