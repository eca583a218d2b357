#pragma once

namespace delcert::python {

/// What the libraries throw becomes the exceptions of python/delcert/errors.py, each of the meaning of an exit status.
void translate_exceptions();

}  // namespace delcert::python
