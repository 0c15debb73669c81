// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Tests use the names of several modules.
namespace edgeproof {
namespace algebra {}
namespace audit {}
namespace certificate {}
namespace comparison {}
namespace conformance {}
namespace contact {}
namespace cost {}
namespace formula {}
namespace io {}
namespace pack {}
namespace parallel {}
namespace quadrature {}
namespace report {}
namespace roots {}
namespace scene {}
namespace series {}
namespace validation {}
} // namespace edgeproof

using namespace edgeproof;
using namespace edgeproof::algebra;
using namespace edgeproof::audit;
using namespace edgeproof::comparison;
using namespace edgeproof::conformance;
using namespace edgeproof::contact;
using namespace edgeproof::cost;
using namespace edgeproof::formula;
using namespace edgeproof::io;
using namespace edgeproof::pack;
using namespace edgeproof::parallel;
using namespace edgeproof::quadrature;
using namespace edgeproof::report;
using namespace edgeproof::roots;
using namespace edgeproof::scene;
using namespace edgeproof::series;
using namespace edgeproof::validation;
