"""Exceptions have the meaning of the exit statuses, and speak of arguments."""

import delcert
from cases import Case, small
from delcert.errors import made


class Errors(Case):
    def test_each_kind_is_raised_by_what_it_is_for(self):
        self.message_of(delcert.Refuted, delcert.certify, "torus-2", lattice=30, no_perturbation=True)
        self.message_of(delcert.MalformedInput, delcert.certify, "tours-2", radius="1/30")
        self.message_of(delcert.Usage, small, chocies=3)
        self.message_of(delcert.MalformedInput, delcert.load, self.folder / "no-such-file.json")

    def test_their_statuses_are_those_of_the_programs(self):
        kinds = (delcert.Refuted, delcert.Undecided, delcert.MalformedInput, delcert.Usage, delcert.Error)
        self.assertEqual([kind.status for kind in kinds], [1, 2, 3, 64, 70])
        self.assertTrue(all(issubclass(kind, delcert.Error) for kind in kinds))

    def test_messages_guess_what_was_meant(self):
        self.assertIn("did you mean torus-2", self.message_of(delcert.MalformedInput, delcert.certify, "tours-2", radius="1/30"))

    def test_options_of_the_command_line_are_arguments(self):
        self.assertEqual(str(made("Usage", "--repair-rounds 3 and --radius")), "repair_rounds 3 and radius")
        message = self.message_of(delcert.MalformedInput, delcert.certify, "torus-2")
        self.assertIn("radius", message)
        self.assertNotIn("--", message)

    def test_no_name_of_the_libraries_is_in_a_message(self):
        for call in (lambda: delcert.certify("tours-2"), lambda: delcert.Claim("altitude"), lambda: delcert.constants(99, 1)):
            with self.assertRaises(delcert.Error) as found:
                call()
            self.assertNotIn("::", str(found.exception))
