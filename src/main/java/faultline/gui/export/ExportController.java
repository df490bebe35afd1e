package faultline.gui.export;

import faultline.engine.SimulationSetup;
import faultline.gui.action.Keystrokes;
import faultline.gui.action.Notes;
import faultline.gui.action.UiAction;
import faultline.gui.canvas.SimulationCanvas;
import faultline.gui.dialog.Dialogs;
import faultline.gui.document.BackgroundTasks;
import faultline.gui.document.Leaving;
import faultline.gui.document.Workspace;
import faultline.gui.document.WorkspaceListener;
import faultline.gui.instrument.StripContent;
import faultline.gui.text.ErrorMessages;
import faultline.gui.text.Messages;
import faultline.gui.theme.Glyph;
import faultline.gui.theme.Theme;
import faultline.io.LinkResolver;
import faultline.io.MessageException;
import faultline.io.WriteProblem;
import faultline.paint.export.PngImage;
import faultline.paint.export.PrintablePage;
import faultline.paint.export.RenderRequest;
import faultline.scenario.Scenario;
import java.awt.Component;
import java.awt.Toolkit;
import java.awt.event.KeyEvent;
import java.awt.print.PrinterAbortException;
import java.awt.print.PrinterJob;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Supplier;
import javax.print.PrintService;

/**
 * Exports what the canvas shows, and the run. Images have the light theme, even in a dark window, unless dark ones are
 * chosen.
 */
public final class ExportController implements WorkspaceListener {

    /** Pixels of an image per pixel of the canvas, in each direction. */
    private static final int RESOLUTION_SCALE = 2;

    private static final long NO_RECORDING = -1;

    private final Component parent;
    private final Workspace workspace;
    private final SimulationCanvas canvas;
    private final BiFunction<String, String, Optional<Path>> fileSelector;
    private final Notes notes;
    private final RunningExports exports;
    private final UiAction recordGif = UiAction.toggle("record", false, this::recordGif)
            .withAccelerator(Keystrokes.menuShortcut(KeyEvent.VK_M))
            .withIcon(Glyph.RECORD);
    private Theme theme = Theme.LIGHT;
    private Supplier<Optional<StripContent>> chart = Optional::empty;
    private Supplier<PrintService[]> printers = PrinterJob::lookupPrintServices;
    private boolean findsPrinters;
    private Supplier<Optional<Boolean>> discardQuestion = () -> Optional.of(true);
    private Consumer<String> errorDialog = this::showErrorDialog;
    /** The first tick of the newest recording, or {@link #NO_RECORDING}, which is less than all ticks. */
    private long recordingStart = NO_RECORDING;
    /** Another object for each recording, and for each scenario. */
    private Object recordingKey = new Object();

    /**
     * Creates a controller. {@code fileSelector} asks for a file, given the key of the dialog's title and the extension
     * with its dot, and returns empty if cancelled; {@code onWritten} is called with each file that has been written,
     * on the event dispatch thread.
     */
    public ExportController(
            Component parent,
            Workspace workspace,
            SimulationCanvas canvas,
            BiFunction<String, String, Optional<Path>> fileSelector,
            Consumer<Path> onWritten,
            Notes notes) {
        this.parent = parent;
        this.workspace = workspace;
        this.canvas = canvas;
        this.fileSelector = fileSelector;
        this.notes = notes;
        exports = new RunningExports(parent, onWritten, sentence -> errorDialog.accept(sentence), notes);
        workspace.addListener(this);
    }

    /** Sets what returns the content of the strip chart; empty if it has none. */
    public void setChart(Supplier<Optional<StripContent>> newChart) {
        chart = newChart;
    }

    /** Sets what asks whether to discard a recording rather than save it; its answer is empty if it is closed. */
    public void setDiscardQuestion(Supplier<Optional<Boolean>> newQuestion) {
        discardQuestion = newQuestion;
    }

    /** Sets what finds the printers of this machine. */
    void setPrinters(Supplier<PrintService[]> newPrinters) {
        printers = newPrinters;
    }

    /** Sets what shows the sentence of a failure. */
    void setErrorDialog(Consumer<String> newDialog) {
        errorDialog = newDialog;
    }

    /** Returns the exports that are being written. */
    public RunningExports exports() {
        return exports;
    }

    /** Returns the actions of the controller. */
    public List<UiAction> actions() {
        return List.of(
                UiAction.of("exportPng", () -> withRenderRequest(this::exportPng))
                        .withAccelerator(Keystrokes.menuShortcut(KeyEvent.VK_E)),
                UiAction.of("exportSvg", () -> withRenderRequest(this::exportSvg)),
                UiAction.of("exportGif", () -> withRenderRequest(request -> exportGif(request, 0))),
                UiAction.of("exportCsv", this::exportCsv),
                UiAction.of("exportChartPng", () -> exportChart("exportChartPng", "-chart.png", this::toPng)),
                UiAction.of("exportChartSvg", () -> exportChart("exportChartSvg", "-chart.svg", this::toSvg)),
                UiAction.of(
                        "exportChartCsv", () -> exportChart("exportChartCsv", "-chart.csv", ExportController::toCsv)),
                UiAction.toggle("exportDark", false, dark -> theme = dark ? Theme.DARK : Theme.LIGHT),
                UiAction.of("copyPicture", () -> withRenderRequest(this::copyImage))
                        .withAccelerator(Keystrokes.menuShiftShortcut(KeyEvent.VK_C)),
                UiAction.of("print", () -> withRenderRequest(this::print))
                        .withAccelerator(Keystrokes.menuShortcut(KeyEvent.VK_P)),
                recordGif);
    }

    private void withRenderRequest(Consumer<RenderRequest> action) {
        canvas.renderRequest(theme.palette()).ifPresent(action);
    }

    private void exportPng(RenderRequest request) {
        write("exportPng", ".png", (out, progress) -> PngImage.write(request.toImage(RESOLUTION_SCALE), out));
    }

    private void exportSvg(RenderRequest request) {
        write("exportSvg", ".svg", (out, progress) -> out.write(request.toSvg().getBytes(StandardCharsets.UTF_8)));
    }

    private void exportChart(String action, String ending, Function<StripContent, FileExport> format) {
        chart.get().ifPresent(content -> write(action, ending, format.apply(content)));
    }

    private FileExport toPng(StripContent content) {
        Theme chosen = theme;
        return (out, progress) -> PngImage.write(content.toImage(chosen, RESOLUTION_SCALE), out);
    }

    private FileExport toSvg(StripContent content) {
        Theme chosen = theme;
        return (out, progress) -> out.write(content.toSvg(chosen).getBytes(StandardCharsets.UTF_8));
    }

    private static FileExport toCsv(StripContent content) {
        return (out, progress) -> out.write(content.toCsv().getBytes(StandardCharsets.UTF_8));
    }

    private void exportGif(RenderRequest request, long from) {
        workspace
                .replayScenario()
                .ifPresent(run -> write("exportGif", ".gif", new AnimatedGifExport(request, run, from)));
    }

    private void exportCsv() {
        workspace
                .replayScenario()
                .ifPresent(run ->
                        write("exportCsv", ".csv", (out, progress) -> HeadlessReplay.writeTrace(run, out, progress)));
    }

    private void recordGif(boolean on) {
        if (on) {
            recordingStart = tick();
            recordingKey = new Object();
        } else {
            withRenderRequest(this::endRecording);
        }
    }

    /**
     * Saves the recording that was switched off, or discards it on request. If the question whether to discard it is
     * closed, the recording continues.
     */
    private void endRecording(RenderRequest request) {
        Object ended = recordingKey;
        recording(request).ifPresent(recording -> {
            Optional<Path> file = selectFile("exportGif", ".gif");
            while (file.isEmpty()) {
                Optional<Boolean> discard = discardQuestion.get();
                if (discard.isEmpty()) {
                    resumeRecording(ended);
                }
                if (discard.orElse(true)) {
                    return;
                }
                file = selectFile("exportGif", ".gif");
            }
            start(file.get(), recording, () -> {}, () -> resumeRecording(ended));
        });
    }

    /** Continues a recording that was not written, unless its run is gone or there is a newer one. */
    private void resumeRecording(Object key) {
        if (key == recordingKey) {
            recordGif.setOn(true);
        }
    }

    private Optional<AnimatedGifExport> recording(RenderRequest request) {
        return workspace.replayScenario().map(run -> new AnimatedGifExport(request, run, recordingStart));
    }

    /**
     * Runs an action that ends the recording, if there is one, after asking whether to discard it. If the question or
     * the choice of a file is cancelled, or the file cannot be written, nothing happens. The recording is on until it
     * is saved, or the action has opened a scenario.
     */
    public void runIfRecordingHandled(Leaving leaving, Runnable action) {
        if (!recordGif.isOn() || leaving.isDiscarded(recordingKey)) {
            action.run();
            return;
        }
        discardQuestion.get().ifPresent(discard -> {
            if (discard) {
                leaving.discard(recordingKey);
                action.run();
            } else {
                withRenderRequest(request -> saveRecording(request, leaving::ask));
            }
        });
    }

    private void saveRecording(RenderRequest request, Runnable then) {
        recording(request).ifPresent(recording -> {
            Object saved = recordingKey;
            Runnable written = () -> {
                // Another recording may have begun while this one was written.
                if (recordingKey == saved) {
                    recordGif.setOn(false);
                }
                then.run();
            };
            selectFile("exportGif", ".gif").ifPresent(file -> start(file, recording, written, () -> {}));
        });
    }

    /** Ends the recording, because its run is gone. */
    @Override
    public void scenarioOpened() {
        recordGif.setOn(false);
        recordingStart = NO_RECORDING;
        recordingKey = new Object();
    }

    @Override
    public void scenarioRestarted(SimulationSetup before) {
        beginRecordingBy(0);
    }

    @Override
    public void runRepositioned(long tick, SimulationSetup setup, boolean eventsOnTimeline) {
        beginRecordingBy(tick);
    }

    /** Moves the start of a recording back to the tick from which the run is simulated again, if it is later. */
    private void beginRecordingBy(long tick) {
        recordingStart = Math.min(recordingStart, tick);
    }

    private long tick() {
        return canvas.frame().map(frame -> frame.snapshot().tick()).orElse(0L);
    }

    private void copyImage(RenderRequest request) {
        TransferableImage.copy(
                request,
                RESOLUTION_SCALE,
                Toolkit.getDefaultToolkit().getSystemClipboard(),
                () -> notes.show(Messages.get("note.imageCopied")),
                failure -> errorDialog.accept(Messages.get("copy.failed", ErrorMessages.describe(failure))));
    }

    /** Looks for printers, which a print server may take long to list, and then asks how to print. */
    private void print(RenderRequest request) {
        if (!findsPrinters) {
            findsPrinters = true;
            BackgroundTasks.compute(
                    printers::get,
                    found -> {
                        findsPrinters = false;
                        print(request, found);
                    },
                    failure -> {
                        findsPrinters = false;
                        printFailed(failure);
                    });
        }
    }

    private void print(RenderRequest request, PrintService... found) {
        // The JDK reports this in its own dialog, in English.
        if (found.length == 0) {
            notes.show(Messages.get("note.noPrinter"));
            return;
        }
        PrinterJob job = PrinterJob.getPrinterJob();
        job.setJobName(workspace.scenario().map(Scenario::name).orElse(""));
        PrintablePage page = new PrintablePage(request);
        job.setPrintable(page, page.oriented(job.defaultPage()));
        if (job.printDialog()) {
            BackgroundTasks.performBeforeExit(
                    job::print, () -> notes.show(Messages.get("note.printed")), this::printFailed);
        }
    }

    private void printFailed(Throwable failure) {
        // The user aborts a job on purpose.
        if (!(failure instanceof PrinterAbortException)) {
            errorDialog.accept(Messages.get("print.failed", ErrorMessages.describe(failure)));
        }
    }

    /** Asks for a file and starts to write it. */
    private void write(String action, String ending, FileExport export) {
        selectFile(action, ending).ifPresent(file -> start(file, export, () -> {}, () -> {}));
    }

    /** Asks for a file; returns none if the choice is cancelled. */
    private Optional<Path> selectFile(String action, String ending) {
        return fileSelector.apply(action, ending);
    }

    /** Starts to write a file, which must not be that of the open scenario. */
    private void start(Path file, FileExport export, Runnable then, Runnable otherwise) {
        List<Path> inputs = workspace.file().stream().toList();
        FileExport checked = (out, progress) -> {
            // A slow disk may take long to say which file a link names.
            if (LinkResolver.findConflict(inputs, List.of(file)).isPresent()) {
                throw new MessageException("", WriteProblem.OWN_INPUT.with(), null);
            }
            export.write(out, progress);
        };
        exports.start(file, checked, then, otherwise);
    }

    private void showErrorDialog(String sentence) {
        Dialogs.showError(parent, sentence);
    }
}
