package faultline.campaign.plan;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class PlanFilesTest {

    @TempDir
    private Path folder;

    /** The mistakes of a plan that is not well-formed are those of a plan, not of a scenario. */
    @ParameterizedTest
    @CsvSource({
        "<campaign xmlns='urn:faultline:campaign:1'/>, true",
        "<campaign xmlns='urn:faultline:campaign:1', true",
        "<scenario xmlns='urn:faultline:scenario:1'/>, false",
        "<scenario xmlns='urn:faultline:scenario:1', false",
        "<scenario xmlns='urn:faultline:scenario:1'><!-- urn:faultline:campaign:1 -->, false"
    })
    void aPlanIsKnownByTheNamespaceOfItsRootElement(String text, boolean isPlan) throws Exception {
        assertEquals(isPlan, PlanFiles.isPlan(Files.writeString(folder.resolve("file.xml"), text)));
    }

    /** The scenario that is read is the one that the outputs of a campaign do not replace. */
    @Test
    @DisabledOnOs(value = OS.WINDOWS, disabledReason = "links need a permission, and do not lead elsewhere")
    void theScenariosOfAPlanInALinkedFolderAreThoseBesideIt() throws Exception {
        Path real = Files.createDirectories(folder.resolve("real/sub"));
        Path link = Files.createSymbolicLink(folder.resolve("link"), real);
        Files.writeString(folder.resolve("s.xml"), SamplePlan.ROOM.replace("Room", "Yard"));
        Path scenario = Files.writeString(folder.resolve("real/s.xml"), SamplePlan.ROOM);
        Files.writeString(
                real.resolve("plan.xml"), SamplePlan.text("", "<worlds><scenario file=\"../s.xml\"/></worlds>"));
        PlanFiles files = PlanFiles.read(link.resolve("plan.xml")).files();
        assertEquals(SamplePlan.ROOM, new String(files.copies().get("scenario-1.xml"), StandardCharsets.UTF_8));
        assertTrue(Files.isSameFile(scenario, files.paths().get(1)));
    }

    @Test
    void whatIsNoFileIsNoPlan() {
        assertFalse(PlanFiles.isPlan(folder));
        assertFalse(PlanFiles.isPlan(folder.resolve("missing.xml")));
    }
}
