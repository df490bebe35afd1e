package faultline.gui.export;

import faultline.gui.action.Keystrokes;
import faultline.gui.action.UiAction;
import faultline.gui.canvas.SimulationCanvas;
import faultline.gui.document.Workspace;
import faultline.gui.text.ErrorMessages;
import faultline.gui.text.Messages;
import faultline.gui.theme.Glyph;
import faultline.paint.export.RenderRequest;
import faultline.paint.surface.Palette;
import java.awt.Component;
import java.awt.Toolkit;
import java.awt.event.KeyEvent;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import javax.imageio.ImageIO;
import javax.swing.JOptionPane;

/**
 * Gives out what the canvas shows and what the run has come to. Pictures are light, on a dark window too, unless dark
 * ones are asked for.
 */
public final class ExportController {

    /** Pictures have so many pixels on each side of one of the window's. */
    private static final double RESOLUTION_SCALE = 2;

    private final Component parent;
    private final Workspace workspace;
    private final SimulationCanvas canvas;
    private final FileSelector fileSelector;
    private final Consumer<Path> onWritten;
    private final UiAction recordGif = UiAction.toggle("record", false, this::recordGif)
            .withAccelerator(Keystrokes.menuShortcut(KeyEvent.VK_M))
            .withIcon(Glyph.RECORD);
    private Palette palette = Palette.LIGHT;
    private long recordingStart;

    /** Asks which file to write. */
    public interface FileSelector {

        /**
         * Asks the user.
         *
         * @param action the key of its title
         * @param extension of the file, with its dot
         * @return empty where the user thinks better of it
         */
        Optional<Path> selectFile(String action, String extension);
    }

    /**
     * A desk.
     *
     * @param parent of dialogs
     * @param bench whose run is given out
     * @param canvas whose view is
     * @param choice asks for files
     * @param written told of each file that was written, on the event dispatch thread
     */
    public ExportController(
            Component parent, Workspace bench, SimulationCanvas canvas, FileSelector choice, Consumer<Path> written) {
        this.parent = parent;
        this.workspace = bench;
        this.canvas = canvas;
        this.fileSelector = choice;
        this.onWritten = written;
    }

    /**
     * What can be asked of it.
     *
     * @return the actions
     */
    public List<UiAction> actions() {
        return List.of(
                UiAction.of("exportPng", () -> withRenderRequest(this::exportPng))
                        .withAccelerator(Keystrokes.menuShortcut(KeyEvent.VK_E)),
                UiAction.of("exportSvg", () -> withRenderRequest(this::exportSvg)),
                UiAction.of("exportGif", () -> withRenderRequest(shot -> exportGif(shot, 0))),
                UiAction.of("exportCsv", this::exportCsv),
                UiAction.toggle("exportDark", false, dark -> palette = dark ? Palette.DARK : Palette.LIGHT),
                UiAction.of("copyPicture", () -> withRenderRequest(this::copyImage))
                        .withAccelerator(Keystrokes.menuShiftShortcut(KeyEvent.VK_C)),
                UiAction.of("print", () -> withRenderRequest(this::print))
                        .withAccelerator(Keystrokes.menuShortcut(KeyEvent.VK_P)),
                recordGif);
    }

    private void withRenderRequest(Consumer<RenderRequest> deed) {
        canvas.renderRequest(palette).ifPresent(deed);
    }

    private void exportPng(RenderRequest shot) {
        write("exportPng", ".png", (out, progress) -> ImageIO.write(shot.toImage(RESOLUTION_SCALE), "png", out));
    }

    private void exportSvg(RenderRequest shot) {
        write("exportSvg", ".svg", (out, progress) -> out.write(shot.toSvg().getBytes(StandardCharsets.UTF_8)));
    }

    private void exportGif(RenderRequest shot, long from) {
        workspace.replayScenario().ifPresent(run -> write("exportGif", ".gif", new AnimatedGifExport(shot, run, from)));
    }

    private void exportCsv() {
        workspace.replayScenario().ifPresent(run -> write("exportCsv", ".csv", new TraceExport(run)));
    }

    private void recordGif(boolean on) {
        if (on) {
            recordingStart = tick();
        } else {
            // A run that was begun anew since has nothing before its own beginning.
            withRenderRequest(shot -> exportGif(shot, recordingStart <= tick() ? recordingStart : 0));
        }
    }

    /** Another scenario is on the bench, and none of what was being recorded. */
    public void scenarioOpened() {
        recordingStart = 0;
    }

    private long tick() {
        return canvas.frame().map(frame -> frame.snapshot().tick()).orElse(0L);
    }

    private void copyImage(RenderRequest shot) {
        new CopyImageTask(shot, RESOLUTION_SCALE, Toolkit.getDefaultToolkit().getSystemClipboard(), this::showError)
                .execute();
    }

    private void print(RenderRequest shot) {
        PrintTask.showDialogAndPrint(
                shot, workspace.scenario().map(scenario -> scenario.name()).orElse(""), this::showError);
    }

    private void write(String action, String extension, FileExport export) {
        fileSelector
                .selectFile(action, extension)
                .ifPresent(file -> new ExportTask(parent, export, file, onWritten, this::showError).start());
    }

    private void showError(Throwable why) {
        JOptionPane.showMessageDialog(
                parent,
                Messages.get("export.failed", ErrorMessages.describe(why)),
                Messages.get("failed.title"),
                JOptionPane.ERROR_MESSAGE);
    }
}
