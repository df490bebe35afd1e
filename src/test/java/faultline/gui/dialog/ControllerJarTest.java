package faultline.gui.dialog;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.Controller;
import faultline.control.ControllerProvider;
import faultline.external.ControllerChoice;
import faultline.external.PythonCommand;
import faultline.external.RightTurner;
import faultline.external.ShellWords;
import faultline.gui.Await;
import faultline.gui.EdtChecker;
import java.awt.BorderLayout;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.jar.JarEntry;
import java.util.jar.JarOutputStream;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JPanel;
import javax.swing.JRootPane;
import javax.swing.JTextField;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;

/** Jars in the dialog that asks for a controller, without a display. */
@ExtendWith(EdtChecker.class)
class ControllerJarTest {

    private static final String COMMAND = "python3 robot.py";

    @TempDir
    private Path folder;

    private ControllerDialog dialog;

    @BeforeEach
    void create() {
        dialog = callOnEdt(
                () -> new ControllerDialog("chooseController", ControllerChoice.of(COMMAND), null, List.of()));
    }

    private Path jar(String name, String provider) throws IOException {
        Path jar = folder.resolve(name);
        try (JarOutputStream out = new JarOutputStream(Files.newOutputStream(jar))) {
            out.putNextEntry(new JarEntry("META-INF/services/" + ControllerProvider.class.getName()));
            out.write(provider.getBytes(StandardCharsets.UTF_8));
        }
        return jar;
    }

    private void useJar(Path jar) {
        runOnEdt(() -> {
            dialog.useFile(jar);
            assertEquals("Loading " + jar.getFileName() + "…", dialog.help());
        });
        Await.until(jar + " to be loaded", () -> !dialog.help().startsWith("Loading"));
    }

    @Test
    void aJarWithoutAControllerIsReported() throws IOException {
        Path empty = jar("empty.jar", "");
        useJar(empty);
        assertEquals(
                "the jar " + empty + " has no controller, because its file META-INF/services/"
                        + ControllerProvider.class.getName()
                        + " names no class of one; expected the full name of the controller's class",
                callOnEdt(dialog::help).replaceAll("\n", " "));
        assertEquals(COMMAND, callOnEdt(dialog::text));
    }

    @Test
    void aJarWhoseControllerCannotBeLoadedIsReported() throws IOException {
        Path broken = jar("broken.jar", "no.such.Turner");
        useJar(broken);
        assertEquals(
                "a controller in Java cannot be loaded: there is no class no.such.Turner, which a file "
                        + "META-INF/services/" + ControllerProvider.class.getName()
                        + " names; expected the full name of a class",
                callOnEdt(dialog::help).replaceAll("\n", " "));
        assertEquals(COMMAND, callOnEdt(dialog::text));
        Path good = jar("turner.jar", RightTurner.class.getName());
        useJar(good);
        assertEquals("right-turner", callOnEdt(dialog::text));
    }

    @Test
    void theDialogOpensWithAJarThatIsBrokenNow() throws IOException {
        ControllerChoice chosen = new ControllerChoice("turner", List.of(jar("broken.jar", "no.such.Turner")));
        ControllerDialog reopened = callOnEdt(() -> new ControllerDialog("chooseController", chosen, null, List.of()));
        assertEquals("turner", callOnEdt(reopened::text));
        Await.until("the reason", () -> reopened.help().startsWith("a controller in Java cannot be loaded: "));
    }

    private static void await(CountDownLatch latch) {
        try {
            assertTrue(latch.await(60, TimeUnit.SECONDS), "the dialog waits for the jar");
        } catch (InterruptedException e) {
            throw new IllegalStateException(e);
        }
    }

    /** A controller whose class takes long to load. */
    public static final class SlowTurner implements ControllerProvider {

        private static volatile CountDownLatch dialogResponds;

        @Override
        public String name() {
            await(dialogResponds);
            return "slow-turner";
        }

        @Override
        public Controller create(Map<String, String> settings) {
            throw new UnsupportedOperationException();
        }
    }

    /** A controller that gives its name only once; the second time, it takes long and then fails. */
    public static final class SlowFailure implements ControllerProvider {

        private static final CountDownLatch OTHER_LOADED = new CountDownLatch(1);
        private static volatile Thread loader;

        @Override
        public String name() {
            if (loader == null) {
                loader = Thread.currentThread();
                return "slow-failure";
            }
            await(OTHER_LOADED);
            throw new IllegalStateException("the name is unknown");
        }

        @Override
        public Controller create(Map<String, String> settings) {
            throw new UnsupportedOperationException();
        }
    }

    @Test
    void theFailureOfAJarThatAnotherOneHasReplacedIsNotShown() throws Exception {
        Path failing = jar("failing.jar", SlowFailure.class.getName());
        runOnEdt(() -> dialog.useFile(failing));
        Await.until("the jar to be read", () -> SlowFailure.loader != null);
        useJar(jar("turner.jar", RightTurner.class.getName()));
        String shown = callOnEdt(dialog::help);
        SlowFailure.OTHER_LOADED.countDown();
        SlowFailure.loader.join();
        assertEquals(shown, callOnEdt(dialog::help));
        assertEquals("right-turner", callOnEdt(dialog::text));
    }

    /** Puts the dialog into a window's pane whose default button accepts it, and returns that button. */
    private JButton acceptButton() {
        return callOnEdt(() -> {
            JButton accept = new JButton("OK");
            JRootPane root = new JRootPane();
            root.getContentPane().add(dialog.createPanel(), BorderLayout.CENTER);
            root.getContentPane().add(accept, BorderLayout.SOUTH);
            root.setDefaultButton(accept);
            return accept;
        });
    }

    @Test
    void theDialogCannotBeAcceptedBeforeItShowsTheControllerOfTheJar() throws IOException {
        JButton accept = acceptButton();
        Path slow = jar("slow.jar", SlowTurner.class.getName());
        SlowTurner.dialogResponds = new CountDownLatch(1);
        assertTrue(callOnEdt(accept::isEnabled));
        runOnEdt(() -> dialog.useFile(slow));
        assertFalse(callOnEdt(accept::isEnabled));
        SlowTurner.dialogResponds.countDown();
        Await.until("the choice", accept::isEnabled);
        assertEquals("slow-turner", callOnEdt(dialog::text));
        useJar(jar("broken.jar", "no.such.Turner"));
        assertTrue(callOnEdt(accept::isEnabled));
    }

    private static void type(String text, JPanel panel) {
        Arrays.stream(panel.getComponents())
                .filter(JComboBox.class::isInstance)
                .map(field -> ((JComboBox<?>) field).getEditor().getEditorComponent())
                .forEach(editor -> ((JTextField) editor).setText(text));
    }

    @Test
    void aTextThatIsTypedWhileAJarIsLoadingIsKept() throws IOException {
        JButton accept = acceptButton();
        Path slow = jar("slow.jar", SlowTurner.class.getName());
        SlowTurner.dialogResponds = new CountDownLatch(1);
        runOnEdt(() -> {
            dialog.useFile(slow);
            type("none", (JPanel) accept.getParent().getComponent(0));
            assertTrue(accept.isEnabled());
            assertTrue(dialog.help().startsWith("For example"), dialog.help());
        });
        SlowTurner.dialogResponds.countDown();
        Await.until("the controller of the jar", () -> dialog.names().contains("slow-turner"));
        assertEquals("none", callOnEdt(dialog::text));
    }

    @Test
    void aProgramCanBeChosenWhileAJarIsLoading() throws IOException {
        SlowTurner.dialogResponds = new CountDownLatch(1);
        Path slow = jar("slow.jar", SlowTurner.class.getName());
        Path script = folder.resolve("robot.sh");
        runOnEdt(() -> {
            dialog.useFile(slow);
            dialog.useFile(script);
        });
        SlowTurner.dialogResponds.countDown();
        Await.until("the controller of the jar", () -> dialog.names().contains("slow-turner"));
        assertEquals(ShellWords.quoted(script.toString()), callOnEdt(dialog::text));
    }

    @Test
    @DisabledOnOs(value = OS.WINDOWS, disabledReason = "no file has such a name there")
    void aProgramWhoseNameHasQuotesIsOneWordOfItsCommand() {
        Path script = Path.of("say \\\"hi\\\".py");
        runOnEdt(() -> dialog.useFile(script));
        assertEquals(List.of(PythonCommand.text(), script.toString()), ShellWords.split(callOnEdt(dialog::text)));
    }

    @Test
    void aJarReplacesAnotherVersionOfItself() throws IOException {
        useJar(jar("turner-1.jar", RightTurner.class.getName()));
        SlowTurner.dialogResponds = new CountDownLatch(0);
        useJar(jar("slow.jar", SlowTurner.class.getName()));
        Path next = jar("turner-2.jar", RightTurner.class.getName());
        useJar(next);
        assertEquals("right-turner", callOnEdt(dialog::text));
        assertTrue(callOnEdt(dialog::names).contains("slow-turner"));
        assertEquals(List.of(folder.resolve("slow.jar"), next), callOnEdt(dialog::jars));
    }

    @Test
    void aJarThatIsChosenAgainGivesItsController() throws IOException {
        Path jar = jar("turner.jar", RightTurner.class.getName());
        Path script = folder.resolve("robot.py");
        useJar(jar);
        assertEquals("right-turner", callOnEdt(dialog::text));
        runOnEdt(() -> dialog.useFile(script));
        String python = PythonCommand.text();
        assertEquals(python + " " + ShellWords.quoted(script.toString()), callOnEdt(dialog::text));
        useJar(jar);
        assertEquals("right-turner", callOnEdt(dialog::text));
        assertEquals(
                "For example: " + python + " \"my follower.py\".\nEach restart loads it again.",
                callOnEdt(dialog::help));
    }
}
