package faultline.gui.export;

import static faultline.gui.GuiRobot.edt;
import static faultline.gui.GuiRobot.onEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.ControllerMode;
import faultline.engine.HeadlessRun;
import faultline.engine.TraceWriter;
import faultline.gui.EdtChecker;
import faultline.gui.Patience;
import faultline.gui.action.UiAction;
import faultline.gui.canvas.SimulationCanvas;
import faultline.gui.document.Bench;
import faultline.gui.document.BenchListener;
import faultline.gui.document.Filing;
import faultline.gui.document.RunDesk;
import faultline.gui.document.Task;
import faultline.gui.edit.EditDesk;
import faultline.gui.text.Language;
import faultline.gui.text.Texts;
import faultline.gui.theme.Theme;
import faultline.paint.Palette;
import faultline.scenario.Scenario;
import java.awt.datatransfer.Clipboard;
import java.awt.datatransfer.ClipboardOwner;
import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.Transferable;
import java.awt.datatransfer.UnsupportedFlavorException;
import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CountDownLatch;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;

/** Each format written from a run and read back, without a display. */
@ExtendWith(EdtChecker.class)
class ExportDeskTest {

    private static final int STEPS = 12;

    @TempDir
    private Path folder;
    private Bench bench;
    private RunDesk run;
    private SimulationCanvas canvas;
    private ExportDesk desk;
    private Filing filing;
    private List<UiAction> actions;
    private final List<Path> written = new ArrayList<>();
    private final List<Throwable> failures = new ArrayList<>();

    @BeforeEach
    void runAFewTicks() {
        edt(() -> {
            Theme.LIGHT.install();
            bench = new Bench(new Quiet());
            run = new RunDesk(bench);
            canvas = new SimulationCanvas(new EditDesk(run::send, () -> {
            }));
            canvas.setSize(300, 200);
            desk = new ExportDesk(canvas, bench, canvas, (action, extension) -> Optional.of(folder.resolve("out" + extension)), written::add);
            actions = desk.actions();
            filing = new Filing(bench);
            filing.open(Path.of("scenarios/office.xml"));
        });
        Patience.waitFor("the scenario", () -> run.frame().isPresent());
        stepTo(STEPS);
    }

    private void stepTo(int tick) {
        for (long i = onEdt(() -> run.frame().orElseThrow().world().tick()); i < tick; i++) {
            edt(run::step);
        }
        Patience.waitFor("the last tick", () -> run.frame().orElseThrow().world().tick() == tick);
        edt(() -> canvas.show(run.frame().orElseThrow()));
    }

    @AfterEach
    void close() {
        edt(bench::close);
    }

    @Test
    void aPictureIsTwiceAsFineAsTheCanvasAndShowsTheSame() throws IOException {
        BufferedImage picture = ImageIO.read(exported("exportPng", ".png").toFile());
        assertEquals(600, picture.getWidth());
        assertEquals(400, picture.getHeight());
        assertEquals(Palette.LIGHT.canvas().getRGB(), picture.getRGB(3, 396));
    }

    @Test
    void picturesAreDarkOnlyWhereThatIsAskedFor() throws IOException {
        edt(Theme.DARK::install);
        assertEquals(Palette.LIGHT.canvas().getRGB(), ImageIO.read(exported("exportPng", ".png").toFile()).getRGB(3, 396));
        Files.delete(folder.resolve("out.png"));
        edt(() -> {
            action("exportDark").putValue(UiAction.SELECTED_KEY, true);
            perform("exportDark");
        });
        assertEquals(Palette.DARK.canvas().getRGB(), ImageIO.read(exported("exportPng", ".png").toFile()).getRGB(3, 396));
        edt(Theme.LIGHT::install);
    }

    @Test
    void aDrawingIsAsLargeAsTheCanvas() throws Exception {
        Path file = exported("exportSvg", ".svg");
        assertEquals("300", DocumentBuilderFactory.newDefaultInstance().newDocumentBuilder().parse(file.toFile()).getDocumentElement()
                .getAttribute("width"));
    }

    @Test
    void whatIsWrittenInPicturesIsInTheLanguageOfTheWindow() {
        edt(() -> Texts.speak(Language.POLISH));
        String off = onEdt(() -> canvas.shot(Palette.LIGHT).orElseThrow().scene().words().switchedOff());
        edt(() -> Texts.speak(Language.ENGLISH));
        assertEquals("wył.", off);
    }

    @Test
    void aTraceIsTheOneThatARunWithoutAWindowWrites() throws Exception {
        StringWriter expected = new StringWriter();
        Scenario scenario = Scenario.load(Path.of("scenarios/office.xml"));
        HeadlessRun.run(scenario.setup().withDuration(STEPS * scenario.setup().dt()), ControllerMode.DIRECT, List.of(new TraceWriter(expected)));
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        new TraceExport(onEdt(() -> bench.replay().orElseThrow())).write(out, share -> assertTrue(share >= 0 && share <= 1));
        assertEquals(expected.toString(), out.toString(StandardCharsets.UTF_8));
    }

    @Test
    void aFilmHasAPictureForEveryTwentiethOfASecond() throws IOException {
        assertEquals(3, pictures(film(0)), "ticks 0, 5 and 10 of 12");
    }

    @Test
    void aFilmCanBeginLater() throws IOException {
        assertEquals(2, pictures(film(4)), "ticks 4 and 9 of 12");
    }

    @Test
    void aFilmBeginsWhereItsRecordingDidThoughTheFileIsAnotherByThen() throws IOException {
        edt(() -> switchRecording(true));
        stepTo(STEPS + 6);
        Path other = folder.resolve("other.xml");
        edt(() -> filing.save(other, () -> written.add(other)));
        Patience.waitFor("the save", () -> written.remove(other));
        assertEquals(2, recorded(), "ticks 12 and 17 of 18");
    }

    @Test
    void ofARecordingThatAnotherScenarioEndedNothingIsLeft() throws IOException {
        edt(() -> switchRecording(true));
        edt(desk::opened);
        assertEquals(3, recorded(), "ticks 0, 5 and 10 of 12");
    }

    private void switchRecording(boolean on) {
        action("record").putValue(UiAction.SELECTED_KEY, on);
        perform("record");
    }

    /** The pictures of the film that ends now. */
    private int recorded() throws IOException {
        edt(() -> switchRecording(false));
        Path file = folder.resolve("out.gif");
        Patience.waitFor("the film", () -> written.remove(file));
        return pictures(Files.readAllBytes(file));
    }

    private FilmExport film(long from) {
        return onEdt(() -> new FilmExport(canvas.shot(Palette.LIGHT).orElseThrow(), bench.replay().orElseThrow(), from));
    }

    private static int pictures(FilmExport film) throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        film.write(out, share -> {
        });
        return pictures(out.toByteArray());
    }

    private static int pictures(byte[] gif) throws IOException {
        ImageReader reader = ImageIO.getImageReadersByFormatName("gif").next();
        reader.setInput(ImageIO.createImageInputStream(new ByteArrayInputStream(gif)));
        return reader.getNumImages(true);
    }

    @Test
    void aFilmThatIsCalledOffStopsAtOnce() {
        FilmExport film = film(0);
        assertThrows(CancellationException.class, () -> film.write(new ByteArrayOutputStream(), share -> {
            throw new CancellationException();
        }));
    }

    @Test
    void theProgramDoesNotEndBeforeAFileIsWhole() {
        Path file = folder.resolve("whole.csv");
        CountDownLatch released = new CountDownLatch(1);
        ExportTask task = onEdt(() -> new ExportTask(canvas, (out, progress) -> {
            try {
                released.await();
            } catch (InterruptedException broken) {
                throw new AssertionError(broken);
            }
        }, file, written::add, why -> {
        }));
        task.begin();
        assertTrue(Thread.getAllStackTraces().keySet().stream().anyMatch(thread -> thread.getName().equals("faultline-guard") && !thread.isDaemon()));
        released.countDown();
        Patience.waitFor("the word that it is written", () -> written.contains(file));
        Patience.waitFor("the end of the thread that keeps the program", () -> Thread.getAllStackTraces().keySet().stream()
                .noneMatch(thread -> thread.getName().equals("faultline-guard")));
    }

    @Test
    void whatIsCancelledLeavesNoFile() throws Exception {
        Path file = folder.resolve("never.csv");
        ExportTask task = onEdt(() -> new ExportTask(canvas, (out, progress) -> {
            out.write(1);
            throw new CancellationException();
        }, file, written::add, why -> {
        }));
        task.begin();
        Patience.waitFor("the end of the task", task::isDone);
        assertFalse(Files.exists(file));
        assertEquals(List.of(), written);
        try (Stream<Path> left = Files.list(folder)) {
            assertEquals(List.of(), left.toList());
        }
    }

    @Test
    void aPictureComesBackFromTheClipboard() throws IOException, UnsupportedFlavorException {
        Clipboard clipboard = new Clipboard("test");
        copyTo(clipboard);
        Patience.waitFor("the picture", () -> clipboard.isDataFlavorAvailable(DataFlavor.imageFlavor));
        assertEquals(600, ((BufferedImage) clipboard.getData(DataFlavor.imageFlavor)).getWidth());
        assertThrows(UnsupportedFlavorException.class, () -> clipboard.getData(DataFlavor.stringFlavor));
    }

    @Test
    void aClipboardThatAnotherProgramHoldsIsToldInOneSentence() {
        copyTo(new Clipboard("busy") {
            @Override
            public synchronized void setContents(Transferable contents, ClipboardOwner owner) {
                throw new IllegalStateException("cannot open system clipboard");
            }
        });
        Patience.waitFor("the failure", () -> !failures.isEmpty());
        assertEquals("The clipboard is in use by another program", failures.get(0).getMessage());
    }

    private void copyTo(Clipboard clipboard) {
        edt(() -> new PictureCopy(canvas.shot(Palette.LIGHT).orElseThrow(), 2, clipboard, failures::add).execute());
    }

    private Path exported(String action, String extension) {
        Path file = folder.resolve("out" + extension);
        edt(() -> perform(action));
        Patience.waitFor("the word that it is written", () -> written.remove(file));
        return file;
    }

    private void perform(String action) {
        action(action).actionPerformed(null);
    }

    private UiAction action(String key) {
        return actions.stream().filter(action -> action.key().equals(key)).findFirst().orElseThrow();
    }

    /** Nothing here fails. */
    private static final class Quiet implements BenchListener {
        @Override
        public void begun() {
            // Frames are asked for.
        }

        @Override
        public void renamed() {
            // Nobody reads the title.
        }

        @Override
        public void failed(Task what, Path file, Throwable why) {
            throw new AssertionError(why);
        }
    }
}
