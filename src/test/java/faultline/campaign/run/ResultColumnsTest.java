package faultline.campaign.run;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.campaign.plan.CampaignPlan;
import faultline.campaign.plan.Column;
import faultline.campaign.plan.SamplePlan;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import org.junit.jupiter.api.Test;

class ResultColumnsTest {

    @Test
    void everyColumnThatIsNotVariedIsReserved() throws Exception {
        CampaignPlan plan = SamplePlan.read(SamplePlan.text("", "<worlds><scenario file=\"room.xml\"/></worlds>"));
        Set<String> names = new HashSet<>();
        ResultColumns.of(plan).forEach(column -> names.add(column.name()));
        assertEquals(CampaignPlan.RESERVED_COLUMNS, names);
    }

    @Test
    void namesAreInLowerSnakeAndEndWithTheirUnits() throws Exception {
        CampaignPlan plan = SamplePlan.read(SamplePlan.text(
                "",
                "<worlds><scenario file=\"room.xml\"/></worlds><set attribute=\"robot/@turnRate\" value=\"30 60\"/>"
                        + "<faults><fault sensor=\"front\" kind=\"off\" at=\"1\"/></faults><masks sensors=\"left\"/>"));
        List<Column> columns = ResultColumns.of(plan);
        for (Column column : columns) {
            String suffix = column.unit().replace('/', '_').toLowerCase(Locale.ROOT);
            assertTrue(column.name().matches("[a-z][a-z0-9_]*"), column.name());
            assertTrue(column.name().endsWith(suffix), column.name() + " is in " + column.unit());
            assertTrue(!column.meaning().isBlank(), column.name());
        }
    }
}
