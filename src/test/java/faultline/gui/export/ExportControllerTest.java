package faultline.gui.export;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.ControllerMode;
import faultline.engine.SampleFrames;
import faultline.engine.metrics.HeadlessRun;
import faultline.engine.trace.TraceFormat;
import faultline.engine.trace.TraceWriter;
import faultline.gui.Await;
import faultline.gui.EdtChecker;
import faultline.gui.action.Notes;
import faultline.gui.action.UiAction;
import faultline.gui.canvas.SimulationCanvas;
import faultline.gui.document.DocumentStore;
import faultline.gui.document.Leaving;
import faultline.gui.document.RunController;
import faultline.gui.document.SessionFrames;
import faultline.gui.document.TaskKind;
import faultline.gui.document.TaskProgress;
import faultline.gui.document.Workspace;
import faultline.gui.document.WorkspaceListener;
import faultline.gui.edit.CommandSender;
import faultline.gui.instrument.StripChart;
import faultline.gui.text.Language;
import faultline.gui.text.Messages;
import faultline.gui.theme.Theme;
import faultline.paint.export.FilmRenderer;
import faultline.paint.export.RenderRequest;
import faultline.paint.surface.Palette;
import faultline.scenario.Scenario;
import java.awt.Color;
import java.awt.EventQueue;
import java.awt.datatransfer.Clipboard;
import java.awt.datatransfer.ClipboardOwner;
import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.Transferable;
import java.awt.datatransfer.UnsupportedFlavorException;
import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.print.PrintService;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Exports a run in every format and reads the result, without a display. */
@ExtendWith(EdtChecker.class)
class ExportControllerTest {

    private static final int STEPS = 12;

    @TempDir
    private Path folder;

    private Workspace workspace;
    private RunController run;
    private SimulationCanvas canvas;
    private ExportController controller;
    private DocumentStore documentStore;
    private List<UiAction> actions;
    /** The number of times that the choice of a file will be cancelled. */
    private int refusals;
    /** What happens while the next file is written. */
    private Runnable whileWriting = () -> {};

    private final List<Path> written = new ArrayList<>();
    private final List<Throwable> failures = new ArrayList<>();
    private final List<String> sentences = new CopyOnWriteArrayList<>();
    private final List<String> notes = new ArrayList<>();
    private final List<String> removedNotes = new ArrayList<>();

    @BeforeEach
    void runAFewTicks() {
        runOnEdt(() -> {
            Theme.LIGHT.install();
            workspace = new Workspace();
            workspace.addListener(new FailingListener());
            run = new RunController(workspace);
            canvas = new SimulationCanvas(new CommandSender(run::send));
            canvas.setSize(300, 200);
            controller = new ExportController(
                    canvas,
                    workspace,
                    canvas,
                    (action, extension) -> {
                        // Before an export that begins now can end.
                        EventQueue.invokeLater(whileWriting);
                        return refusals-- > 0 ? Optional.empty() : Optional.of(folder.resolve("out" + extension));
                    },
                    written::add,
                    new Notes(notes::add, notes::add, notes::add, removedNotes::add));
            actions = controller.actions();
            documentStore = new DocumentStore(workspace);
            documentStore.open(Path.of("scenarios/office.xml"));
        });
        SessionFrames.awaitScenario(workspace);
        stepTo(STEPS);
    }

    private void stepTo(int tick) {
        for (long i = SessionFrames.tick(workspace); i < tick; i++) {
            runOnEdt(run::step);
        }
        SessionFrames.awaitTick(workspace, tick);
        runOnEdt(() -> canvas.setFrame(SessionFrames.frame(workspace).frame()));
    }

    @AfterEach
    void close() {
        runOnEdt(workspace::close);
    }

    @Test
    void anImageHasTwiceTheResolutionOfTheCanvasAndShowsTheSame() throws IOException {
        BufferedImage picture = ImageIO.read(exportToFile("exportPng", ".png").toFile());
        assertEquals(600, picture.getWidth());
        assertEquals(400, picture.getHeight());
        assertEquals(Palette.LIGHT.canvas().getRGB(), picture.getRGB(3, 396));
    }

    @Test
    void theFilesOfAChartHaveOtherNamesThanThoseOfTheRun() throws IOException {
        runOnEdt(() -> {
            StripChart chart = new StripChart();
            chart.setSize(560, 220);
            chart.setFrame(SessionFrames.frame(workspace));
            controller.setChart(chart::content);
        });
        Path run = exportToFile("exportPng", ".png");
        Path chart = exportToFile("exportChartPng", "-chart.png");
        assertTrue(Files.mismatch(run, chart) >= 0);
        assertTrue(Files.size(exportToFile("exportChartSvg", "-chart.svg")) > 0);
        assertTrue(Files.size(exportToFile("exportChartCsv", "-chart.csv")) > 0);
    }

    @Test
    void aNoteIsShownWhileAFileIsWritten() {
        runOnEdt(() -> {
            perform("exportGif");
            assertEquals(List.of("Writing out.gif"), notes);
            assertEquals(List.of(), removedNotes);
        });
        Await.until("the export", () -> !written.isEmpty());
        assertEquals(notes, callOnEdt(() -> List.copyOf(removedNotes)));
    }

    /** A print server may take long to list its printers. */
    @Test
    void withoutAPrinterANoteSaysSo() {
        AtomicBoolean blocksTheWindow = new AtomicBoolean(true);
        runOnEdt(() -> {
            controller.setPrinters(() -> {
                blocksTheWindow.set(EventQueue.isDispatchThread());
                return new PrintService[0];
            });
            perform("print");
            perform("print");
        });
        Await.until("the note", () -> !notes.isEmpty());
        assertEquals(List.of("No printer is installed"), notes);
        assertFalse(blocksTheWindow.get());
    }

    @Test
    void imagesAreDarkOnlyOnRequest() throws IOException {
        runOnEdt(Theme.DARK::install);
        assertEquals(
                Palette.LIGHT.canvas().getRGB(),
                ImageIO.read(exportToFile("exportPng", ".png").toFile()).getRGB(3, 396));
        Files.delete(folder.resolve("out.png"));
        runOnEdt(() -> {
            action("exportDark").putValue(UiAction.SELECTED_KEY, true);
            perform("exportDark");
        });
        assertEquals(
                Palette.DARK.canvas().getRGB(),
                ImageIO.read(exportToFile("exportPng", ".png").toFile()).getRGB(3, 396));
        runOnEdt(Theme.LIGHT::install);
    }

    @Test
    void anSvgDrawingHasTheSizeOfTheCanvas() throws Exception {
        Path file = exportToFile("exportSvg", ".svg");
        assertEquals(
                "300",
                DocumentBuilderFactory.newDefaultInstance()
                        .newDocumentBuilder()
                        .parse(file.toFile())
                        .getDocumentElement()
                        .getAttribute("width"));
    }

    @Test
    void textsInImagesAreInTheLanguageOfTheWindow() {
        runOnEdt(() -> Messages.setLanguage(Language.POLISH));
        String off = callOnEdt(() -> canvas.renderRequest(Palette.LIGHT)
                .orElseThrow()
                .painter()
                .labels()
                .switchedOff());
        runOnEdt(() -> Messages.setLanguage(Language.ENGLISH));
        assertEquals("wył.", off);
    }

    @Test
    void anExportedTraceEqualsThatOfAHeadlessRun() throws Exception {
        ByteArrayOutputStream expected = new ByteArrayOutputStream();
        Scenario scenario = Scenario.load(Path.of("scenarios/office.xml"));
        try (TraceWriter trace = new TraceWriter(expected, TraceFormat.ONE)) {
            HeadlessRun.run(
                    scenario.setup().withDuration(STEPS * scenario.setup().dt()),
                    ControllerMode.DIRECT,
                    List.of(trace));
            trace.flush();
        }
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        TaskProgress progress = new TaskProgress();
        HeadlessReplay.writeTrace(callOnEdt(() -> workspace.replayScenario().orElseThrow()), out, progress);
        assertEquals(OptionalDouble.of(1), progress.fraction());
        assertArrayEquals(expected.toByteArray(), out.toByteArray());
    }

    @Test
    void anAnimatedGifHasAFrameForEveryTwentiethOfASecond() throws IOException {
        assertEquals(3, frameCount(gifExport(0)), "ticks 0, 5 and 10 of 12");
    }

    @Test
    void anAnimatedGifCanStartLater() throws IOException {
        assertEquals(2, frameCount(gifExport(4)), "ticks 4 and 9 of 12");
    }

    @Test
    void anAnimatedGifStartsAtTheStartOfTheRecordingEvenIfTheFileHasChanged() throws IOException {
        runOnEdt(() -> setRecording(true));
        stepTo(STEPS + 6);
        Path other = folder.resolve("other.xml");
        runOnEdt(() -> documentStore.save(other, () -> written.add(other)));
        Await.until("the save", () -> written.remove(other));
        assertEquals(2, recordedFrameCount(), "ticks 12 and 17 of 18");
    }

    @Test
    void aRecordingHasTheWholeRunThatIsStartedAgain() throws IOException {
        runOnEdt(() -> setRecording(true));
        runOnEdt(run::restart);
        Await.until("the restart", () -> SessionFrames.tick(workspace) == 0);
        stepTo(STEPS + 6);
        assertEquals(4, recordedFrameCount(), "ticks 0, 5, 10 and 15 of 18");
    }

    @Test
    void aRecordingHasTheRunFromTheTimeToWhichItIsMovedBack() throws IOException {
        runOnEdt(() -> setRecording(true));
        runOnEdt(() -> run.navigator().seek(7));
        SessionFrames.awaitTick(workspace, 7);
        stepTo(STEPS + 6);
        assertEquals(3, recordedFrameCount(), "ticks 7, 12 and 17 of 18");
    }

    @Test
    void aRecordingEndsWithItsScenario() {
        runOnEdt(() -> setRecording(true));
        runOnEdt(controller::scenarioOpened);
        assertFalse(callOnEdt(action("record")::isOn));
    }

    @Test
    void theScenarioIsLeftWhenTheRecordingIsSavedOrDiscarded() throws IOException {
        List<Optional<Boolean>> answers =
                new ArrayList<>(List.of(Optional.empty(), Optional.of(true), Optional.of(false)));
        List<String> left = new ArrayList<>();
        runOnEdt(() -> {
            controller.setDiscardQuestion(() -> answers.remove(0));
            leave(() -> left.add("no recording"));
            assertEquals(3, answers.size());
            setRecording(true);
            leave(() -> left.add("closed"));
            assertTrue(action("record").isOn());
            leave(() -> left.add("discarded"));
        });
        stepTo(STEPS + 6);
        runOnEdt(() -> leave(() -> left.add("saved")));
        Await.until("the end", () -> left.contains("saved"));
        assertEquals(List.of("no recording", "discarded", "saved"), left);
        assertEquals(2, frameCount(Files.readAllBytes(folder.resolve("out.gif"))), "ticks 12 and 17 of 18");
        assertFalse(callOnEdt(action("record")::isOn));
    }

    @Test
    void theScenarioIsNotLeftWhenTheChoiceOfAFileIsCancelled() {
        List<Optional<Boolean>> answers = new ArrayList<>(List.of(Optional.of(false), Optional.of(true)));
        List<String> left = new ArrayList<>();
        runOnEdt(() -> {
            controller.setDiscardQuestion(() -> answers.remove(0));
            refusals = 1;
            setRecording(true);
            leave(() -> left.add("saved"));
        });
        assertEquals(List.of(), left);
        assertEquals(1, answers.size(), "asked once");
        assertTrue(callOnEdt(action("record")::isOn));
    }

    private void leave(Runnable action) {
        Leaving.begin(leaving -> controller.runIfRecordingHandled(leaving, action));
    }

    @Test
    void onlyAnotherRecordingThanTheDiscardedOneIsAskedAboutAgain() {
        List<String> questions = new ArrayList<>();
        List<String> left = new ArrayList<>();
        runOnEdt(() -> {
            controller.setDiscardQuestion(() -> {
                questions.add("discard");
                return Optional.of(true);
            });
            setRecording(true);
            Leaving.begin(leaving -> controller.runIfRecordingHandled(leaving, () -> {
                left.add(questions.toString());
                if (left.size() == 1) {
                    leaving.ask();
                    controller.scenarioOpened();
                    setRecording(true);
                    leaving.ask();
                }
            }));
        });
        assertEquals(List.of("[discard]", "[discard]", "[discard, discard]"), left);
    }

    @Test
    void aRecordingThatIsBegunWhileAnotherIsSavedIsAskedAbout() {
        List<Optional<Boolean>> answers = new ArrayList<>(List.of(Optional.of(false), Optional.of(true)));
        List<Boolean> left = new ArrayList<>();
        runOnEdt(() -> {
            controller.setDiscardQuestion(() -> answers.remove(0));
            setRecording(true);
        });
        stepTo(STEPS + 6);
        runOnEdt(() -> {
            whileWriting = () -> {
                controller.scenarioOpened();
                setRecording(true);
            };
            leave(() -> left.add(action("record").isOn()));
        });
        Await.until("the end", () -> !left.isEmpty());
        assertEquals(List.of(true), left, "the second recording is on until the scenario is left");
        assertEquals(List.of(), answers);
    }

    /** The action can still be cancelled, or fail. */
    @Test
    void aDiscardedRecordingIsOnUntilTheScenarioIsLeft() {
        runOnEdt(() -> {
            setRecording(true);
            leave(() -> {});
            assertTrue(action("record").isOn());
            leave(controller::scenarioOpened);
            assertFalse(action("record").isOn());
        });
    }

    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void aRecordingThatCannotBeWrittenIsKept(boolean leaves) throws IOException {
        List<String> left = new ArrayList<>();
        Path file = Files.createDirectory(folder.resolve("out.gif"));
        runOnEdt(() -> {
            controller.setDiscardQuestion(() -> Optional.of(false));
            controller.setErrorDialog(sentences::add);
            setRecording(true);
        });
        stepTo(STEPS + 6);
        runOnEdt(() -> {
            if (leaves) {
                leave(() -> left.add("left"));
            } else {
                setRecording(false);
            }
        });
        Await.until("the failure", () -> !sentences.isEmpty());
        assertEquals(List.of(), left);
        assertTrue(callOnEdt(action("record")::isOn));
        Files.delete(file);
        assertEquals(2, recordedFrameCount(), "ticks 12 and 17 of 18");
    }

    @Test
    void aRecordingThatCannotBeWrittenIsGoneWithItsScenario() throws IOException {
        Files.createDirectory(folder.resolve("out.gif"));
        runOnEdt(() -> {
            controller.setErrorDialog(sentences::add);
            setRecording(true);
            setRecording(false);
            controller.scenarioOpened();
        });
        Await.until("the failure", () -> !sentences.isEmpty());
        assertFalse(callOnEdt(action("record")::isOn));
    }

    @Test
    void aRecordingThatCannotBeWrittenIsKeptIfTheRunIsMovedBackMeanwhile() throws IOException {
        Path file = Files.createDirectory(folder.resolve("out.gif"));
        runOnEdt(() -> {
            controller.setErrorDialog(sentences::add);
            setRecording(true);
            setRecording(false);
            controller.runRepositioned(4, workspace.scenario().orElseThrow().setup(), false);
        });
        Await.until("the failure", () -> !sentences.isEmpty());
        assertTrue(callOnEdt(action("record")::isOn));
        Files.delete(file);
        assertEquals(2, recordedFrameCount(), "ticks 4 and 9 of 12");
    }

    @Test
    void aRecordingThatCannotBeWrittenIsNotKeptIfAnotherOneHasBegunAtItsTick() throws IOException {
        Files.createDirectory(folder.resolve("out.gif"));
        runOnEdt(() -> {
            controller.setErrorDialog(sentences::add);
            setRecording(true);
            setRecording(false);
            refusals = 1;
            setRecording(true);
            setRecording(false);
        });
        Await.until("the failure", () -> !sentences.isEmpty());
        assertFalse(callOnEdt(action("record")::isOn));
    }

    @Test
    void aRecordingWithoutAFileIsDiscardedOnlyOnRequest() throws IOException {
        List<Optional<Boolean>> answers =
                new ArrayList<>(List.of(Optional.of(false), Optional.of(true), Optional.empty()));
        runOnEdt(() -> {
            controller.setDiscardQuestion(() -> answers.remove(0));
            refusals = 1;
            setRecording(true);
        });
        stepTo(STEPS + 6);
        assertEquals(2, recordedFrameCount(), "ticks 12 and 17 of 18");
        assertEquals(2, answers.size());
        runOnEdt(() -> {
            refusals = 1;
            setRecording(true);
            setRecording(false);
        });
        assertEquals(1, answers.size(), "discarded");
    }

    @Test
    void aRecordingContinuesIfTheQuestionWhetherToDiscardItIsClosed() throws IOException {
        List<Optional<Boolean>> answers = new ArrayList<>(List.of(Optional.empty(), Optional.of(true)));
        runOnEdt(() -> {
            controller.setDiscardQuestion(() -> answers.remove(0));
            refusals = 2;
            setRecording(true);
            setRecording(false);
            assertTrue(action("record").isOn());
            assertEquals(1, answers.size(), "asked once");
            refusals = 0;
        });
        stepTo(STEPS + 6);
        assertEquals(2, recordedFrameCount(), "ticks 12 and 17 of 18");
    }

    private void setRecording(boolean on) {
        action("record").putValue(UiAction.SELECTED_KEY, on);
        perform("record");
    }

    /** Ends the recording and returns the number of images of the animated GIF. */
    private int recordedFrameCount() throws IOException {
        runOnEdt(() -> setRecording(false));
        Path file = folder.resolve("out.gif");
        Await.until("the GIF", () -> written.remove(file));
        return frameCount(Files.readAllBytes(file));
    }

    private AnimatedGifExport gifExport(long from) {
        return callOnEdt(() -> new AnimatedGifExport(
                canvas.renderRequest(Palette.LIGHT).orElseThrow(),
                workspace.replayScenario().orElseThrow(),
                from));
    }

    private static int frameCount(AnimatedGifExport gif) throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        gif.write(out, new TaskProgress());
        return frameCount(out.toByteArray());
    }

    private static int frameCount(byte[] gif) throws IOException {
        ImageReader reader = ImageIO.getImageReadersByFormatName("gif").next();
        reader.setInput(ImageIO.createImageInputStream(new ByteArrayInputStream(gif)));
        return reader.getNumImages(true);
    }

    @Test
    void eachImageOfAnAnimatedGifShowsItsTime() {
        RenderRequest request = gifExport(0).renderRequest();
        FilmRenderer film = new FilmRenderer();
        BufferedImage start = film.render(request.withFrame(SampleFrames.fullFrame()));
        BufferedImage same = film.render(request.withFrame(SampleFrames.fullFrame()));
        int height = start.getHeight();
        assertArrayEquals(clock(start), clock(same));
        assertTrue(textPixels(clock(start)) > 10, "no digits");
        BufferedImage plain = request.withFrame(SampleFrames.fullFrame()).toImage(1);
        assertEquals(height, plain.getHeight());
        assertFalse(Arrays.equals(clock(start), clock(plain)), "the time is not shown");
        stepTo(200);
        BufferedImage later =
                film.render(request.withFrame(callOnEdt(() -> canvas.frame().orElseThrow())));
        assertFalse(Arrays.equals(clock(start), clock(later)), "the time does not change");
    }

    /** Returns the pixels at the middle of the lower edge. */
    private static int[] clock(BufferedImage image) {
        return image.getRGB(image.getWidth() / 2 - 20, image.getHeight() - 28, 40, 22, null, 0, 40);
    }

    /** Returns the number of dark pixels; antialiasing makes few of a text as dark as its colour. */
    private static long textPixels(int[] pixels) {
        return IntStream.of(pixels)
                .filter(pixel -> new Color(pixel).getGreen() < 110)
                .count();
    }

    @Test
    void aCancelledGifExportStopsAtOnce() {
        AnimatedGifExport gif = gifExport(0);
        TaskProgress progress = new TaskProgress();
        progress.cancel();
        assertThrows(CancellationException.class, () -> gif.write(new ByteArrayOutputStream(), progress));
    }

    @Test
    void theProgramDoesNotExitBeforeAFileIsComplete() {
        Path file = folder.resolve("whole.csv");
        CountDownLatch released = new CountDownLatch(1);
        ExportTask task = callOnEdt(() -> new ExportTask(
                canvas,
                (out, progress) -> {
                    try {
                        released.await();
                    } catch (InterruptedException broken) {
                        throw new AssertionError(broken);
                    }
                },
                file,
                () -> {},
                written::add,
                failure -> {}));
        runOnEdt(task::start);
        assertTrue(Thread.getAllStackTraces().keySet().stream()
                .anyMatch(thread -> thread.getName().equals("faultline-background") && !thread.isDaemon()));
        released.countDown();
        Await.until("the export", () -> written.contains(file));
        Await.until("the end of the background thread", () -> Thread.getAllStackTraces().keySet().stream()
                .noneMatch(thread -> thread.getName().equals("faultline-background") && !thread.isDaemon()));
    }

    @Test
    void aCancelledExportLeavesNoFile() throws Exception {
        Path file = folder.resolve("never.csv");
        ExportTask task = callOnEdt(() -> new ExportTask(
                canvas,
                (out, progress) -> {
                    out.write(1);
                    throw new CancellationException();
                },
                file,
                () -> {},
                written::add,
                failure -> {}));
        runOnEdt(task::start);
        Await.until("the end of the task", task::isDone);
        assertFalse(Files.exists(file));
        assertEquals(List.of(), written);
        try (Stream<Path> left = Files.list(folder)) {
            assertEquals(List.of(), left.toList());
        }
    }

    @Test
    void aCopiedImageCanBeReadFromTheClipboard() throws IOException, UnsupportedFlavorException {
        Clipboard clipboard = new Clipboard("test");
        copyTo(clipboard);
        Await.until("the picture", () -> clipboard.isDataFlavorAvailable(DataFlavor.imageFlavor));
        assertEquals(600, ((BufferedImage) clipboard.getData(DataFlavor.imageFlavor)).getWidth());
        Await.until("the note", () -> notes.equals(List.of("copied")));
        assertThrows(UnsupportedFlavorException.class, () -> clipboard.getData(DataFlavor.stringFlavor));
    }

    @Test
    void aBusyClipboardIsReportedInOneSentence() {
        copyTo(new Clipboard("busy") {
            @Override
            public synchronized void setContents(Transferable contents, ClipboardOwner owner) {
                throw new IllegalStateException("cannot open system clipboard");
            }
        });
        Await.until("the failure", () -> !failures.isEmpty());
        assertEquals("Another program is using the clipboard", failures.get(0).getMessage());
    }

    private void copyTo(Clipboard clipboard) {
        runOnEdt(() -> TransferableImage.copy(
                canvas.renderRequest(Palette.LIGHT).orElseThrow(),
                2,
                clipboard,
                () -> notes.add("copied"),
                failures::add));
    }

    private Path exportToFile(String action, String extension) {
        Path file = folder.resolve("out" + extension);
        runOnEdt(() -> perform(action));
        Await.until("the export", () -> written.remove(file));
        return file;
    }

    private void perform(String action) {
        action(action).actionPerformed(null);
    }

    private UiAction action(String key) {
        return actions.stream()
                .filter(action -> action.key().equals(key))
                .findFirst()
                .orElseThrow();
    }

    /** No task may fail. */
    private static final class FailingListener implements WorkspaceListener {
        @Override
        public void taskFailed(TaskKind task, Path file, Throwable failure) {
            throw new AssertionError(failure);
        }
    }
}
