package faultline.gui.export;

import faultline.gui.action.Keystrokes;
import faultline.gui.action.UiAction;
import faultline.gui.canvas.SimulationCanvas;
import faultline.gui.document.Bench;
import faultline.gui.text.Reasons;
import faultline.gui.text.Texts;
import faultline.gui.theme.Glyph;
import faultline.paint.Palette;
import faultline.paint.Shot;
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
 * Gives out what the canvas shows and what the run has come to. Pictures are light, on a dark window too, unless dark ones are asked for.
 */
public final class ExportDesk {

    /** Pictures have so many pixels on each side of one of the window's. */
    private static final double FINENESS = 2;

    private final Component parent;
    private final Bench bench;
    private final SimulationCanvas canvas;
    private final FileChoice choice;
    private final Consumer<Path> written;
    private final UiAction record = UiAction.toggle("record", false, this::record).on(Keystrokes.menu(KeyEvent.VK_M)).drawn(Glyph.RECORD);
    private Palette palette = Palette.LIGHT;
    private long recordedFrom;

    /** Asks which file to write. */
    public interface FileChoice {

        /**
         * Asks the user.
         *
         * @param action the key of its title
         * @param extension of the file, with its dot
         * @return empty where the user thinks better of it
         */
        Optional<Path> fileFor(String action, String extension);
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
    public ExportDesk(Component parent, Bench bench, SimulationCanvas canvas, FileChoice choice, Consumer<Path> written) {
        this.parent = parent;
        this.bench = bench;
        this.canvas = canvas;
        this.choice = choice;
        this.written = written;
    }

    /**
     * What can be asked of it.
     *
     * @return the actions
     */
    public List<UiAction> actions() {
        return List.of(
                UiAction.of("exportPng", () -> withShot(this::png)).on(Keystrokes.menu(KeyEvent.VK_E)),
                UiAction.of("exportSvg", () -> withShot(this::svg)),
                UiAction.of("exportGif", () -> withShot(shot -> film(shot, 0))),
                UiAction.of("exportCsv", this::csv),
                UiAction.toggle("exportDark", false, dark -> palette = dark ? Palette.DARK : Palette.LIGHT),
                UiAction.of("copyPicture", () -> withShot(this::copy)).on(Keystrokes.menuShift(KeyEvent.VK_C)),
                UiAction.of("print", () -> withShot(this::print)).on(Keystrokes.menu(KeyEvent.VK_P)),
                record);
    }

    private void withShot(Consumer<Shot> deed) {
        canvas.shot(palette).ifPresent(deed);
    }

    private void png(Shot shot) {
        write("exportPng", ".png", (out, progress) -> ImageIO.write(shot.image(FINENESS), "png", out));
    }

    private void svg(Shot shot) {
        write("exportSvg", ".svg", (out, progress) -> out.write(shot.svg().getBytes(StandardCharsets.UTF_8)));
    }

    private void film(Shot shot, long from) {
        bench.replay().ifPresent(run -> write("exportGif", ".gif", new FilmExport(shot, run, from)));
    }

    private void csv() {
        bench.replay().ifPresent(run -> write("exportCsv", ".csv", new TraceExport(run)));
    }

    private void record(boolean on) {
        if (on) {
            recordedFrom = tick();
        } else {
            // A run that was begun anew since has nothing before its own beginning.
            withShot(shot -> film(shot, recordedFrom <= tick() ? recordedFrom : 0));
        }
    }

    /** Another scenario is on the bench, and none of what was being recorded. */
    public void opened() {
        recordedFrom = 0;
    }

    private long tick() {
        return canvas.frame().map(frame -> frame.world().tick()).orElse(0L);
    }

    private void copy(Shot shot) {
        new PictureCopy(shot, FINENESS, Toolkit.getDefaultToolkit().getSystemClipboard(), this::failed).execute();
    }

    private void print(Shot shot) {
        Printout.offer(shot, bench.scenario().map(scenario -> scenario.name()).orElse(""), this::failed);
    }

    private void write(String action, String extension, Export export) {
        choice.fileFor(action, extension).ifPresent(file -> new ExportTask(parent, export, file, written, this::failed).begin());
    }

    private void failed(Throwable why) {
        JOptionPane.showMessageDialog(parent, Texts.text("export.failed", Reasons.of(why)), Texts.text("failed.title"), JOptionPane.ERROR_MESSAGE);
    }
}
