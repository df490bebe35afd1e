package faultline.gui.dialog;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.gui.Await;
import faultline.gui.EdtChecker;
import faultline.gui.document.Workspace;
import java.nio.file.Path;
import javax.swing.JPanel;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;

@ExtendWith(EdtChecker.class)
class FileControllerTest {

    private final Workspace workspace = callOnEdt(Workspace::new);
    private final FileController files = callOnEdt(() -> new FileController(new JPanel(), workspace, () -> false));

    @AfterEach
    void close() {
        runOnEdt(workspace::close);
    }

    /** The command line may name the file by a path that is relative to the working directory. */
    @Test
    void filesAreSavedBesideTheOpenOne() {
        Path office = Path.of("scenarios/office.xml");
        runOnEdt(() -> files.openWithoutAsking(office));
        Await.until("open", () -> workspace.file().isPresent());
        assertEquals(office.toAbsolutePath(), callOnEdt(files::suggestedScenarioFile));
        assertEquals(Path.of("scenarios/office.csv").toAbsolutePath(), callOnEdt(() -> files.suggestedFile(".csv")));
    }

    @Test
    void aScenarioWithoutAFileIsSavedInTheFolderOfTheLastDialog() {
        assertEquals(Path.of("scenario.xml"), callOnEdt(files::suggestedScenarioFile));
    }
}
