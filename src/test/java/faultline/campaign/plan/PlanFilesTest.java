package faultline.campaign.plan;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
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

    @Test
    void whatIsNoFileIsNoPlan() {
        assertFalse(PlanFiles.isPlan(folder));
        assertFalse(PlanFiles.isPlan(folder.resolve("missing.xml")));
    }
}
