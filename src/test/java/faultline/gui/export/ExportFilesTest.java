package faultline.gui.export;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.gui.Await;
import faultline.gui.EdtChecker;
import faultline.gui.action.Notes;
import faultline.gui.action.UiAction;
import faultline.gui.canvas.SimulationCanvas;
import faultline.gui.document.DocumentStore;
import faultline.gui.document.RunController;
import faultline.gui.document.SessionFrames;
import faultline.gui.document.TaskProgress;
import faultline.gui.document.Workspace;
import faultline.gui.edit.CommandSender;
import faultline.gui.instrument.StripChart;
import faultline.gui.instrument.StripContent;
import faultline.gui.theme.Theme;
import faultline.io.ForwardingFileSystemProvider;
import faultline.scenario.Scenario;
import java.awt.EventQueue;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.AccessMode;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.ImageInputStream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** The files that the actions of the menu write, and those that they do not. */
@ExtendWith(EdtChecker.class)
class ExportFilesTest {

    private static final int STEPS = 12;

    @TempDir
    private Path folder;

    private Workspace workspace;
    private RunController run;
    private SimulationCanvas canvas;
    private ExportController controller;
    private DocumentStore documentStore;
    private List<UiAction> actions;

    private final List<Path> written = new CopyOnWriteArrayList<>();
    private final List<String> sentences = new CopyOnWriteArrayList<>();

    @BeforeEach
    void runAFewTicks() {
        runOnEdt(() -> {
            workspace = new Workspace();
            run = new RunController(workspace);
            canvas = new SimulationCanvas(new CommandSender(run::send));
            canvas.setSize(300, 200);
            controller = new ExportController(
                    canvas,
                    workspace,
                    canvas,
                    (action, extension) -> Optional.of(folder.resolve("out" + extension)),
                    written::add,
                    new Notes(note -> {}, note -> {}, note -> {}, note -> {}));
            controller.setErrorDialog(sentences::add);
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

    private UiAction action(String key) {
        return actions.stream()
                .filter(action -> action.key().equals(key))
                .findFirst()
                .orElseThrow();
    }

    private Path export(String key, String extension) {
        Path file = folder.resolve("out" + extension);
        runOnEdt(() -> action(key).actionPerformed(null));
        Await.until("the export", () -> written.remove(file));
        return file;
    }

    private void set(String key, boolean on) {
        runOnEdt(() -> {
            action(key).putValue(UiAction.SELECTED_KEY, on);
            action(key).actionPerformed(null);
        });
    }

    private static int frameCount(Path gif) throws IOException {
        ImageReader reader = ImageIO.getImageReadersByFormatName("gif").next();
        try (ImageInputStream in = ImageIO.createImageInputStream(gif.toFile())) {
            reader.setInput(in);
            return reader.getNumImages(true);
        }
    }

    @ParameterizedTest
    @EnumSource(names = {"LIGHT", "DARK"})
    void theFilesOfAChartShowItsContentInTheChosenTheme(Theme theme) throws IOException {
        StripContent content = callOnEdt(() -> {
            StripChart chart = new StripChart();
            chart.setSize(560, 220);
            chart.setFrame(SessionFrames.frame(workspace));
            return chart.content().orElseThrow();
        });
        controller.setChart(() -> Optional.of(content));
        set("exportDark", theme == Theme.DARK);
        BufferedImage image =
                ImageIO.read(export("exportChartPng", "-chart.png").toFile());
        BufferedImage expected = content.toImage(theme, 2);
        assertEquals(expected.getWidth(), image.getWidth());
        assertEquals(expected.getRGB(1, 1), image.getRGB(1, 1));
        assertEquals(content.toSvg(theme), Files.readString(export("exportChartSvg", "-chart.svg")));
        assertEquals(content.toCsv(), Files.readString(export("exportChartCsv", "-chart.csv")));
    }

    @Test
    void theTraceHasARowForEveryTick() throws IOException {
        ByteArrayOutputStream expected = new ByteArrayOutputStream();
        HeadlessReplay.writeTrace(
                callOnEdt(() -> workspace.replayScenario().orElseThrow()), expected, new TaskProgress());
        byte[] trace = Files.readAllBytes(export("exportCsv", ".csv"));
        assertArrayEquals(expected.toByteArray(), trace);
        assertEquals(STEPS + 2, new String(trace).lines().count(), "a header and ticks 0 to 12");
    }

    @Test
    void anAnimatedGifOfTheMenuShowsTheWholeRunEvenIfAPartIsRecorded() throws IOException {
        assertEquals(3, frameCount(export("exportGif", ".gif")), "ticks 0, 5 and 10 of 12");
        set("record", true);
        assertEquals(3, frameCount(export("exportGif", ".gif")), "ticks 0, 5 and 10 of 12");
    }

    @Test
    void aRecordingOfARunThatWasRestartedShowsItFromItsStart() throws IOException {
        set("record", true);
        runOnEdt(run::restart);
        SessionFrames.awaitFrame(
                workspace, "the restart", frame -> frame.frame().snapshot().tick() == 0);
        stepTo(6);
        set("record", false);
        Path file = folder.resolve("out.gif");
        Await.until("the GIF", () -> written.remove(file) || !sentences.isEmpty());
        assertEquals(List.of(), sentences);
        assertEquals(2, frameCount(file), "ticks 0 and 5 of 6");
    }

    @Test
    void openingAScenarioEndsTheRecording() {
        set("record", true);
        runOnEdt(() -> documentStore.open(Path.of("scenarios/front-sensor-dies.xml")));
        SessionFrames.awaitFrame(
                workspace, "the scenario", frame -> frame.frame().snapshot().tick() == 0);
        assertFalse(callOnEdt(action("record")::isOn));
    }

    @Test
    void theOpenScenarioIsNotReplaced() throws IOException {
        Path file = folder.resolve("out.svg");
        runOnEdt(() -> documentStore.save(file, () -> written.add(file)));
        Await.until("the save", () -> written.remove(file));
        String scenario = Files.readString(file);
        runOnEdt(() -> action("exportSvg").actionPerformed(null));
        Await.until("the failure", () -> !sentences.isEmpty());
        assertEquals(
                List.of(file + " cannot be written: this is the open scenario itself; expected another file"),
                sentences);
        assertEquals(scenario, Files.readString(file));
    }

    /** A disk may take long to answer. */
    private static final class AskedFiles extends ForwardingFileSystemProvider {

        private final Set<Boolean> askedByEventThread = ConcurrentHashMap.newKeySet();

        @Override
        public <A extends BasicFileAttributes> A readAttributes(Path path, Class<A> type, LinkOption... options)
                throws IOException {
            askedByEventThread.add(EventQueue.isDispatchThread());
            return super.readAttributes(path, type, options);
        }

        @Override
        public void checkAccess(Path path, AccessMode... modes) throws IOException {
            askedByEventThread.add(EventQueue.isDispatchThread());
            super.checkAccess(path, modes);
        }
    }

    @Test
    void theEventThreadDoesNotWaitForTheDisk() {
        AskedFiles disk = new AskedFiles();
        Path file = disk.forwarding(folder).resolve("out.svg");
        UiAction export = callOnEdt(() -> new ExportController(
                        canvas,
                        workspace,
                        canvas,
                        (action, extension) -> Optional.of(file),
                        written::add,
                        new Notes(note -> {}, note -> {}, note -> {}, note -> {}))
                .actions().stream()
                        .filter(action -> action.key().equals("exportSvg"))
                        .findFirst()
                        .orElseThrow());
        runOnEdt(() -> export.actionPerformed(null));
        Await.until("the export", () -> written.equals(List.of(file)));
        assertEquals(Set.of(false), disk.askedByEventThread);
    }

    /** Nobody reads the pipe, so a write to it would not end. */
    @Test
    @DisabledOnOs(value = OS.WINDOWS, disabledReason = "has no mkfifo")
    void aPipeIsRefused() throws Exception {
        Path pipe = folder.resolve("out.svg");
        assertEquals(0, new ProcessBuilder("mkfifo", pipe.toString()).start().waitFor());
        runOnEdt(() -> action("exportSvg").actionPerformed(null));
        Await.until("the failure", () -> !sentences.isEmpty());
        assertEquals(List.of(pipe + " cannot be written: this is a device or a pipe; expected a file"), sentences);
    }

    @Test
    void anExportThatIsCancelledAfterItsLastByteLeavesNoFile() {
        Path file = folder.resolve("never.csv");
        List<Object> ends = new ArrayList<>();
        ExportTask task = callOnEdt(() ->
                new ExportTask(canvas, (out, progress) -> progress.cancel(), file, () -> {}, ends::add, ends::add));
        runOnEdt(task::start);
        Await.until("the end of the task", () -> task.isDone() && !ends.isEmpty());
        assertInstanceOf(CancellationException.class, callOnEdt(() -> ends.get(0)));
        assertTrue(Files.notExists(file));
    }

    @Test
    void aReplayFailsWithTheReasonOfItsFile() {
        IOException full = new IOException("the disk is full");
        CompletableFuture<Scenario> scenario =
                callOnEdt(() -> workspace.replayScenario().orElseThrow());
        assertSame(
                full,
                assertThrows(
                        IOException.class,
                        () -> HeadlessReplay.run(
                                scenario,
                                simulation -> {
                                    throw full;
                                },
                                new TaskProgress())));
    }

    @Test
    void aReplayOfARunThatIsGoneFailsWithItsReason() {
        CompletableFuture<Scenario> gone = CompletableFuture.failedFuture(new IllegalStateException("the run is gone"));
        IOException failure =
                assertThrows(IOException.class, () -> HeadlessReplay.run(gone, simulation -> {}, new TaskProgress()));
        assertEquals("the run is gone", failure.getMessage());
    }
}
